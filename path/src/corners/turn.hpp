// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <vector>

#include "jounce/profiles/curve/segment.hpp"

// The corner of two lines with directions u and w, D = w - u (docs/path/README.md, "Turns"):
//
//   (1)  r' = u + D T(x),   x = q / l,   T from 0 to 1: T' rises over a share b of x, holds 1 / (1 - b), falls
//   (2)  both trims are l / 2: q has the same length as the two sides
//   (3)  the corner's distance is e = |D| l i,   i(b) = (3 - 6 b + 4 b^2) / (24 (1 - b)),   0 <= b <= 1/2
//   (4)  at constant q' = v the acceleration is at most v^2 |D_i| / ((1 - b) l), the jerk v^3 |D_i| / (b (1 - b) l^2)
//   (5)  the greatest curvature is |D| / ((1 - b) l C^2), C the cosine of half the angle
//
// Tajima and Sencer's kinematic smoothing; e, i and (5) are integrals of (1).
namespace jounce {

/// Integral of T with three derivatives by x.
Jet turn_rise(double share, double x);

/// i of (3).
inline double turn_offset(double share) {
  return (3 - share * (6 - 4 * share)) / (24 * (1 - share));
}

/// The segments of one axis: three, two for a share of 1/2, one for 0.
void turn_segments(double start, double before, double after, double length, double share,
                   std::vector<Segment>& out);

/// Limits of a turn, those of the tightest axis: acceleration and jerk per |D_i|.
struct TurnRates {
  static constexpr double none = std::numeric_limits<double>::infinity();
  double acceleration = none;
  double jerk = none;
};

struct Turn {
  double share = 0;
  double length = 0;
  double velocity = std::numeric_limits<double>::infinity();  ///< greatest, by (4)
};

/// The fastest turn with e / |D| <= offset and a length of at most `length`.
Turn fastest_turn(const TurnRates& rates, double offset, double length);

/// The turn of the least deviation that may be passed at a velocity; its length is not bounded.
Turn least_turn(const TurnRates& rates, double velocity);

/// The turn of the least length whose curvature, |D| / C^2 = `bend` over (1 - share) l, is at most `curvature`.
Turn curved_turn(const TurnRates& rates, double bend, double curvature);

/// (4).
double turn_velocity(const TurnRates& rates, double share, double length);

}  // namespace jounce
