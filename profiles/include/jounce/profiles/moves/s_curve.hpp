// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "jounce/profiles/moves/profile.hpp"

namespace jounce {

/// A move with trapezoidal velocity, from rest to rest. u is the axis' unit.
struct TrapezoidSpec {
  double from = 0;          ///< u
  double to = 0;            ///< u; must differ from `from`
  double velocity = 0;      ///< u/s, > 0; not reached by a short move
  double acceleration = 0;  ///< u/s^2, > 0
  double deceleration = 0;  ///< u/s^2, >= 0; 0: the same as acceleration
};

/// Returns the time-optimal move under the limits. Throws InputError for a value out of range.
Profile trapezoid(const TrapezoidSpec& spec);

/// An S-curve of up to seven phases, from rest to rest: the acceleration changes at the given jerk.
struct SCurveSpec {
  double from = 0;               ///< u
  double to = 0;                 ///< u, not equal to `from`
  double velocity = 0;           ///< u/s, > 0; not reached by a short move
  double acceleration = 0;       ///< u/s^2, > 0; not reached by a short move
  double deceleration = 0;       ///< u/s^2, >= 0; 0: the same as acceleration
  double jerk = 0;               ///< u/s^3, > 0, while speeding up
  double deceleration_jerk = 0;  ///< u/s^3, >= 0, while slowing down; 0: the same as jerk
};

/// Returns the time-optimal move under the limits. The part that speeds up and the part that slows
/// down each have their own acceleration and jerk. Throws InputError for a value out of range, and
/// for a jerk so high that its phases are below the rounding of the duration.
Profile s_curve(const SCurveSpec& spec);

}  // namespace jounce
