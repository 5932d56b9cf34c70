#pragma once

#include <cstdint>
#include <vector>

#include "jounce/axis/axis.hpp"
#include "jounce/cam/cam_switch.hpp"
#include "jounce/stream/message.hpp"

namespace jounce {

/// What the outputs of an axis did between two of its ticks, as messages: each with the instant at
/// which it happened, s before the later tick, and where the axis (or the master that its
/// switches are of) was then. Ascending in time; `count`ed on from `last_count`.
///
/// The place is taken from the cubic through both ticks with their velocities, as the instant is
/// (cam/cam_switches.hpp). `period`: ns of a tick.
std::vector<wire::Event> events_of(const Tick& before, const Tick& now, SwitchesOf of,
                                   std::int64_t period, std::int64_t last_count);

}  // namespace jounce
