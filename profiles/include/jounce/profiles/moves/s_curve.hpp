// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "jounce/profiles/moves/profile.hpp"

namespace jounce {

/// Trapezoidal velocity, rest to rest.
struct TrapezoidSpec {
  double from = 0;          ///< u
  double to = 0;            ///< u; must differ from `from`
  double velocity = 0;      ///< u/s, > 0; not reached by a short move
  double acceleration = 0;  ///< u/s^2, > 0
  double deceleration = 0;  ///< u/s^2, > 0; 0: as acceleration
};

/// Time-optimal under the limits. Throws InputError for a value out of range.
Profile trapezoid(const TrapezoidSpec& spec);

/// Seven-segment S-curve, rest to rest: acceleration ramps at the given jerk.
struct SCurveSpec {
  double from = 0;               ///< u
  double to = 0;                 ///< u, not equal to `from`
  double velocity = 0;           ///< u/s, > 0
  double acceleration = 0;       ///< u/s^2, > 0
  double deceleration = 0;       ///< u/s^2; 0: as acceleration
  double jerk = 0;               ///< u/s^3, > 0, of the accelerating half
  double deceleration_jerk = 0;  ///< u/s^3, of the decelerating half; 0: as jerk
};

/// Time-optimal under the limits, each half with its own acceleration and jerk. Velocity and
/// acceleration are not reached by short moves. Throws InputError for a value out of range.
Profile s_curve(const SCurveSpec& spec);

}  // namespace jounce
