// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "jounce/axis/axis_config.hpp"
#include "jounce/command/cause.hpp"
#include "jounce/profiles/moves/profile.hpp"

namespace jounce {

/// Permitted changes between two setpoints, besides the limits.
struct StepAllowance {
  double dt = 0;             ///< s between them
  double velocity_step = 0;  ///< u/s: the velocity steps with which the path was admitted
};

/// Compares a setpoint with the previous one, `last`, before it goes out: finite values and no jump
/// of the velocity beyond the stop acceleration (`jump`), the velocity and the distance
/// (`overspeed`), the position range (`out_of_range`; an axis outside may return). none: it may go
/// out.
Cause check_setpoint(const MotionState& last, const MotionState& next, const StepAllowance& step,
                     const AxisConfig& config) noexcept;

/// The stops of an axis, from the gentlest to the hardest.
enum class Stop : std::uint8_t {
  soft,     ///< to rest with limit_acceleration (PMC600 fSWLimitDeceleration)
  hard,     ///< to rest with stop_acceleration
  turning,  ///< brakes with stop_acceleration, reverses at the end of the range, then rests
  none,     ///< no stop stays inside the range
};

/// Returns the gentlest stop from this state that stays inside the position range, at the end with
/// the smaller reserve. From outside the range, returns a stop that does not lead further out.
Stop gentlest_stop(const MotionState& state, const AxisConfig& config) noexcept;

/// The rule of the position range: `next` must not lose the gentlest stop that the previous
/// setpoint, `last`, had. The axis can therefore stop inside the range at every tick. Returns
/// positive_soft_limit or negative_soft_limit if `next` violates the rule; that stop from `last`
/// then exists.
Cause check_range(const MotionState& last, const MotionState& next,
                  const AxisConfig& config) noexcept;

/// True if the velocity exceeds its limit, or will exceed it before the acceleration can fall to 0
/// with stop_jerk.
bool exceeds_velocity(const MotionState& state, const AxisConfig& config) noexcept;

/// True if a motion stays inside the range, or returns to it, up to rounding.
bool stays_inside(const Profile& motion, const AxisConfig& config) noexcept;

}  // namespace jounce
