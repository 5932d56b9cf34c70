// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <vector>

#include "jounce/profiles/curve/segment.hpp"

// The corner of two lines with directions u and w, D = w - u (docs/path/README.md, "Turns"):
//
//   (1)  r' = u + D T(x),   x = q / l,   T from 0 to 1: T' rises over a share b of x, is then
//        1 / (1 - b), and falls over a share b
//   (2)  both trims are l / 2: q has the same length as the two sides
//   (3)  the corner's distance is e = |D| l i, where
//        i(b) = (3 - 6 b + 4 b^2) / (24 (1 - b)),   0 <= b <= 1/2
//   (4)  at constant q' = v the acceleration is at most v^2 |D_i| / ((1 - b) l), the
//        jerk at most v^3 |D_i| / (b (1 - b) l^2)
//   (5)  the greatest curvature is |D| / ((1 - b) l C^2), C the cosine of half the angle
//
// Tajima and Sencer's kinematic smoothing; e, i and (5) are integrals of (1).
namespace jounce {

/// The integral of T over x, with three derivatives with respect to x.
Jet turn_rise(double share, double x);

/// The function i of (3).
inline double turn_offset(double share) {
  return (3 - share * (6 - 4 * share)) / (24 * (1 - share));
}

/// Appends the segments of one axis: three; two if the share is 1/2; one if it is 0.
void turn_segments(double start, double before, double after, double length, double share,
                   std::vector<Segment>& out);

/// Limits of a turn: acceleration and jerk of the tightest axis, divided by |D_i|.
struct TurnRates {
  static constexpr double none = std::numeric_limits<double>::infinity();
  double acceleration = none;
  double jerk = none;
};

struct Turn {
  double share = 0;
  double length = 0;
  double velocity = std::numeric_limits<double>::infinity();  ///< greatest velocity, by (4)
};

/// The fastest turn with e / |D| <= `offset` and at most this length.
Turn fastest_turn(const TurnRates& rates, double offset, double length);

/// The turn of the least deviation that can be passed at this velocity; its length is not limited.
Turn least_turn(const TurnRates& rates, double velocity);

/// The shortest turn whose curvature is at most `curvature`. `bend`: |D| / C^2 of (5); the
/// curvature is bend / ((1 - share) l).
Turn curved_turn(const TurnRates& rates, double bend, double curvature);

/// The greatest velocity of a turn, by (4).
double turn_velocity(const TurnRates& rates, double share, double length);

}  // namespace jounce
