// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "jounce/axis/axis_config.hpp"
#include "jounce/command/cause.hpp"
#include "jounce/profiles/moves/profile.hpp"

namespace jounce {

/// Permitted change from one setpoint to the next.
struct StepAllowance {
  double dt = 0;  ///< time between the setpoints, s
  /// Velocity step that the checked path may contain, u/s (unit of the axis).
  double velocity_step = 0;
  /// Greatest velocity of the checked path, u/s. By the rounding of its knots it may exceed the limit
  /// by KnotRounding::greatest_excess.
  double velocity = 0;
};

/// Compares the setpoint `next` with the previous setpoint `last`, before it is output. Returns
/// none if it may be output. Otherwise returns `jump` (a value that is not finite, or a change of
/// velocity beyond the stop acceleration), `overspeed` (velocity or distance), or `out_of_range`
/// (the position range; an axis outside the range may return into it).
Cause check_setpoint(const MotionState& last, const MotionState& next, const StepAllowance& step,
                     const AxisConfig& config) noexcept;

/// The stops of an axis before the end of its position range, from the gentlest to the hardest.
enum class Stop : std::uint8_t {
  soft,     ///< brakes with limit_acceleration to rest (PMC600 fSWLimitDeceleration)
  hard,     ///< brakes with stop_acceleration to rest
  turning,  ///< brakes with stop_acceleration, reverses at the end of the range, and comes to rest
  none,     ///< no stop stays inside the range
};

/// Returns the gentlest stop from this state that stays inside the position range, at the end of
/// the range that is more critical. From outside the range, returns a stop that does not lead
/// further out.
Stop gentlest_stop(const MotionState& state, const AxisConfig& config) noexcept;

/// Checks that the axis can always stop inside its position range: the gentlest stop that was
/// possible at the setpoint `last` must still be possible at the setpoint `next`. Returns none, or
/// positive_soft_limit or negative_soft_limit if it is not. In that case, the stop from `last` is
/// still possible.
Cause check_range(const MotionState& last, const MotionState& next,
                  const AxisConfig& config) noexcept;

/// The speed that the axis reaches even if stop_jerk reduces the acceleration to 0 from now on, u/s.
double reached_speed(const MotionState& state, const AxisConfig& config) noexcept;

/// True if the reached speed exceeds the limit of the velocity.
bool exceeds_velocity(const MotionState& state, const AxisConfig& config) noexcept;

/// True if the speed rises, and the acceleration exceeds its limit. While the speed falls, a follower
/// may need up to stop_acceleration: it brakes with its leader.
bool exceeds_acceleration(const MotionState& state, const AxisConfig& config) noexcept;

/// True if the motion stays inside the position range, or returns into it, up to rounding.
bool stays_inside(const Profile& motion, const AxisConfig& config) noexcept;

}  // namespace jounce
