// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "jounce/profiles/moves/profile.hpp"

namespace jounce::profiles_detail {

/// Limits of a velocity ramp, in one sense (speeding up, or slowing down).
struct RampLimits {
  double acceleration = 0;  ///< u/s^2, > 0, magnitude
  double jerk_begin = 0;    ///< u/s^3, from zero to the greatest acceleration; 0: not limited
  double jerk_end = 0;      ///< u/s^3, from there to zero; both are limited, or neither is

  bool operator==(const RampLimits&) const = default;
};

/// velocity_ramp() of jounce/profiles/moves/dynamics.hpp with a jerk for the begin and one for the
/// end of a ramp (Googol GT_MoveVelocity); `up` while the axis speeds up, `down` while it slows
/// down. The jerks may differ between begin and end, or between up and down, but not both.
Profile velocity_ramp(const MotionState& from, double velocity, const RampLimits& up,
                      const RampLimits& down);

}  // namespace jounce::profiles_detail
