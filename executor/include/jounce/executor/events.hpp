// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "jounce/axis/axis.hpp"
#include "jounce/cam/switches/cam_switch.hpp"
#include "jounce/stream/message/message.hpp"

namespace jounce {

/// State of the outputs of an axis.
struct OutputsOf {
  SwitchesOf switches = SwitchesOf::position;
  SwitchesOf compare = SwitchesOf::position;
};

/// Output changes of an axis between two of its ticks, cam switches and position compare, as
/// messages: each with the instant at which it happened, s before the later tick, and where the axis
/// (or its master, or its drive) was then. Ascending in time; `count`ed on from `last_count`.
///
/// The place is taken from the cubic through both ticks with their velocities, as the instant is
/// (jounce/profiles/curve/cycle_motion.hpp); of an actual position from a straight line. `period`: ns of a tick.
std::vector<wire::Event> events_of(const Tick& before, const Tick& now, const OutputsOf& of,
                                   std::int64_t period, std::int64_t last_count);

}  // namespace jounce
