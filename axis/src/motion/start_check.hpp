// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "jounce/axis/axis_config.hpp"
#include "jounce/axis/movement.hpp"
#include "jounce/command/cause.hpp"
#include "jounce/profiles/moves/profile.hpp"

namespace jounce {

/// The checks of a movement at its start. Each returns nullopt, or the reason to reject the start;
/// none changes the movement. u is the unit of the axis, m the unit of its master.

/// The answer of Movement::begin() with its numbers. `state`: the state of the axis.
Refusal begin_refusal(Cause no, const Movement& movement, const MotionState& state) noexcept;

/// Rejects a path that leads outwards from an active limit switch. `position`: of the axis, u.
std::optional<Refusal> against_switch(const Movement& path, bool positive_switch,
                                      bool negative_switch, double position) noexcept;

/// Rejects a coupling whose slave would exceed a limit at the moment `start`.
std::optional<Refusal> against_demand(const Movement& movement, const Moment& start,
                                      const AxisConfig& config) noexcept;

/// Rejects a coupling that has begun, and whose first setpoint after the setpoint `last` would be a
/// fault. `rules` has the limits in effect.
std::optional<Refusal> against_jump(const Movement& movement, const Moment& now,
                                    const MotionState& last, const AxisConfig& rules) noexcept;

/// The reason to drop a movement that waited for an event of its master, because the first setpoint
/// in motion would be the fault `wrong`. Returns nullopt for a fault that remains one.
std::optional<Refusal> against_first(Cause wrong, const MotionState& first, double last_velocity,
                                     const AxisConfig& config) noexcept;

/// Returns the instant at which the master passes `position`, m, between the previous tick (its
/// master is `before`) and this one (`after`); nullopt: it does not. `dt`: s between both ticks.
std::optional<Moment> crossing(double position, const Jet& before, const Jet& after,
                               double dt) noexcept;

}  // namespace jounce
