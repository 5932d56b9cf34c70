// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "jounce/profiles/curve/curve.hpp"

namespace jounce {

/// A move of fourth order, rest to rest: velocity, acceleration, jerk and jounce (the derivative of
/// jerk, also called snap) are limited.
///
///     const Trajectory move = fourth_order(
///         {.to = 0.1, .velocity = 0.25, .acceleration = 2, .jerk = 40, .jounce = 2000});
///     const double T = move.length();                 // s
///     const Report report = check(move, {.jerk = 40});
///
/// Up to 15 phases of constant jounce, each an exact segment of degree 4; phases that do not occur
/// are omitted. Begins and ends with velocity, acceleration and jerk zero, continuous up to the
/// jerk; holds outside [0, T].
struct FourthOrderSpec {
  double from = 0;          ///< u
  double to = 0;            ///< u, not equal to `from`
  double velocity = 0;      ///< u/s, > 0
  double acceleration = 0;  ///< u/s^2, > 0, also of the deceleration
  double jerk = 0;          ///< u/s^3, > 0
  double jounce = 0;        ///< u/s^4, > 0
};

/// Symmetric in time. Time-optimal while the velocity limit is not reached; a move that reaches it
/// is within 0.1 % of the least duration, which would take infinitely many phases. Throws
/// InputError for a value out of range, and for a jounce so high that its phases vanish in
/// comparison with the move. Source: Lambrechts, Boerlage, Steinbuch, "Trajectory planning and
/// feedforward design for electromechanical motion systems", Control Engineering Practice 13
/// (2005), whose profile this is if there is a cruise; shorter moves are up to 7 % faster than
/// theirs (jounce.cpp).
Trajectory fourth_order(const FourthOrderSpec& spec);

}  // namespace jounce
