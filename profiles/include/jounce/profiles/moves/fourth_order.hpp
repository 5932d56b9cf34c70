// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "jounce/profiles/curve/curve.hpp"

namespace jounce {

/// A move of fourth order from rest to rest: it has limits of velocity, acceleration, jerk and
/// jounce (the derivative of the jerk, also called snap). u is the axis' unit.
///
///     const Trajectory move = fourth_order(
///         {.to = 0.1, .velocity = 0.25, .acceleration = 2, .jerk = 40, .jounce = 2000});
///     const double T = move.length();                 // s
///     const Report report = check(move, {.jerk = 40});
///
/// The motion has up to 15 phases of constant jounce, each an exact segment of degree 4; phases
/// that do not occur are omitted. Velocity, acceleration and jerk are zero at both ends and
/// continuous between them. The curve holds outside [0, T].
struct FourthOrderSpec {
  double from = 0;          ///< u
  double to = 0;            ///< u, not equal to `from`
  double velocity = 0;      ///< u/s, > 0
  double acceleration = 0;  ///< u/s^2, > 0; also the limit of the deceleration
  double jerk = 0;          ///< u/s^3, > 0
  double jounce = 0;        ///< u/s^4, > 0
};

/// Returns the move, which is symmetric in time. If the velocity limit is not reached, the move is
/// time-optimal. Otherwise its duration exceeds the minimum by at most 0.1 %; the exact minimum
/// would need infinitely many phases. Throws InputError for a value out of range, and for a jounce
/// so high that its phases are below the rounding of the duration.
///
/// Source: Lambrechts, Boerlage, Steinbuch, "Trajectory planning and feedforward design for
/// electromechanical motion systems", Control Engineering Practice 13 (2005). With a cruise, the
/// move is the profile of this paper. Shorter moves are up to 7 % faster than the moves of the
/// paper (derivation: fourth_order.cpp).
Trajectory fourth_order(const FourthOrderSpec& spec);

}  // namespace jounce
