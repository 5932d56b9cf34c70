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
/// messages. Each has its instant, s before the later tick, and the position of the axis (or of its
/// master, or its drive) at that instant. Ascending in time; counted from `last_count` on.
///
/// The position is on the cubic through both ticks with their velocities, like the instant
/// (jounce/profiles/curve/cycle_motion.hpp); an actual position is on a straight line. `period`: ns
/// of a tick.
std::vector<wire::Event> events_of(const Tick& before, const Tick& now, const OutputsOf& of,
                                   std::int64_t period, std::int64_t last_count);

}  // namespace jounce
