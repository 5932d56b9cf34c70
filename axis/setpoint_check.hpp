#pragma once

#include "jounce/axis/axis_config.hpp"
#include "jounce/axis/cause.hpp"
#include "jounce/profiles/profile.hpp"

namespace jounce {

/// What may happen between two setpoints besides what the limits allow.
struct StepAllowance {
  double dt = 0;             ///< s between them
  double velocity_step = 0;  ///< u/s: the kinks that the path was admitted with
};

/// Compares a setpoint with the one given out before, `last`, before it goes out: finite and no leap of
/// the velocity beyond the stop acceleration (`jump`), the velocity, and the way (`overspeed`),
/// the position range (`out_of_range`; who is outside may come back). none: it may go out.
Cause check_setpoint(const MotionState& last, const MotionState& next, const StepAllowance& step,
                     const AxisConfig& config) noexcept;

/// Whether a stop with limit_acceleration (PMC600 fSWLimitDeceleration) from this state would end
/// outside the position range: positive_soft_limit, negative_soft_limit, or none.
Cause check_stopping(const MotionState& next, const AxisConfig& config) noexcept;

}  // namespace jounce
