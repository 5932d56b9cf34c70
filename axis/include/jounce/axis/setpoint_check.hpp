// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "jounce/axis/axis_config.hpp"
#include "jounce/axis/cause.hpp"
#include "jounce/profiles/moves/profile.hpp"

namespace jounce {

/// Permitted changes between two setpoints, besides the limits.
struct StepAllowance {
  double dt = 0;             ///< s between them
  double velocity_step = 0;  ///< u/s: the kinks that the path was admitted with
};

/// Compares a setpoint with the one given out before, `last`, before it goes out: finite and no leap of
/// the velocity beyond the stop acceleration (`jump`), the velocity, and the way (`overspeed`),
/// the position range (`out_of_range`; who is outside may come back). none: it may go out.
Cause check_setpoint(const MotionState& last, const MotionState& next, const StepAllowance& step,
                     const AxisConfig& config) noexcept;

/// The stops of an axis, from the gentlest to the hardest.
enum class Stop : std::uint8_t {
  soft,     ///< to rest with limit_acceleration (PMC600 fSWLimitDeceleration)
  hard,     ///< to rest with stop_acceleration
  turning,  ///< brakes with stop_acceleration, reverses at the end of the range, then rests
  none,     ///< no stop stays inside the range
};

/// The gentlest stop from this state that stays inside the position range; at the end that is worse off.
/// From outside the range, one that does not lead further out.
Stop gentlest_stop(const MotionState& state, const AxisConfig& config) noexcept;

/// The rule of the position range: `next` may not lose the gentlest stop that the setpoint before it,
/// `last`, had. So the axis can stop inside the range at every tick: where positive_soft_limit or
/// negative_soft_limit means that `next` breaks the rule; that stop from `last` exists.
Cause check_range(const MotionState& last, const MotionState& next,
                  const AxisConfig& config) noexcept;

/// True if the velocity exceeds its limit, or will before the acceleration can come down to 0 with stop_jerk.
bool exceeds_velocity(const MotionState& state, const AxisConfig& config) noexcept;

/// True if a motion stays inside the range, or comes back to it, up to rounding.
bool stays_inside(const Profile& motion, const AxisConfig& config) noexcept;

}  // namespace jounce
