// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "jounce/axis/tick.hpp"
#include "jounce/cam/switches/cam_switch.hpp"
#include "jounce/stream/message/message.hpp"

namespace jounce {

/// Returns the output changes of an axis between two of its ticks (cam switches and position
/// compare) as messages, in chronological order. Each message has its instant, s before the later
/// tick, and the position of the axis (or of its master, or its drive) at that instant; `of`: the
/// position of the cam switches. The position compare gives its own positions: those of a group are
/// lengths along the path. The messages are numbered from last_count + 1.
///
/// Instants and positions are computed on the cubic through both ticks and their velocities
/// (jounce/profiles/curve/cycle_motion.hpp). An actual position is interpolated linearly. `period`:
/// duration of a tick, ns.
std::vector<wire::Event> events_of(const Tick& before, const Tick& now, SwitchesOf of,
                                   std::int64_t period, std::int64_t last_count);

}  // namespace jounce
