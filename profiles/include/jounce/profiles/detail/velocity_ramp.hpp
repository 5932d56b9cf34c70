// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "jounce/profiles/moves/profile.hpp"

namespace jounce::profiles_detail {

/// Limits of a velocity ramp, in one sense (speeding up, or slowing down).
struct RampLimits {
  double acceleration = 0;  ///< u/s^2, > 0, magnitude
  double jerk_begin = 0;    ///< u/s^3, from zero to the greatest acceleration
  double jerk_end = 0;      ///< u/s^3, from the greatest acceleration to zero

  bool operator==(const RampLimits&) const = default;
};

/// Like velocity_ramp() of jounce/profiles/moves/dynamics.hpp, but with separate jerks for the
/// begin and the end of a ramp (Googol GT_MoveVelocity). `up` applies while the axis speeds up,
/// `down` while the axis slows down. The jerks may differ between begin and end or between `up` and
/// `down`, but not in both ways. Either all four jerks are 0 (not limited), or none is.
Profile velocity_ramp(const MotionState& from, double velocity, const RampLimits& up,
                      const RampLimits& down);

}  // namespace jounce::profiles_detail
