// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "jounce/pvt/table.hpp"

namespace jounce::test {

/// A table over time that accelerates until `place` s, makes a short bump of the jerk, and stops at
/// 2 `place`. The rounding of the knots can cause the whole bump.
struct ShortInterval {
  double place = 0;   ///< s
  double length = 0;  ///< s
  double velocity = 0;
  double bump = 0;  ///< distance beyond the constant velocity; the jerk is 60 bump / length^3
  double permitted = 0.0;  ///< greatest share of the limit by which the jerk may exceed it

  /// `second`: length of a second in the unit of the table, such as 1/60 min.
  [[nodiscard]] Table table(double second = 1) const {
    const double up = velocity * place / 2;
    const double then = up + velocity * length + bump;
    return Table(Domain::time, Interpolation::quintic_hermite, Extrapolation::hold,
                 {{0, place * second, (place + length) * second, 2 * place * second},
                  {0, up, then, then + up},
                  {0, velocity / second, velocity / second, 0},
                  {0, 0, 0, 0}});
  }
};

/// A cubic table over time with two points that are `apart` s from each other, around 1 s. Both have the
/// velocity of 7.5. The position of the second point is `units` units in the last place beyond that of a
/// constant velocity.
inline Table near_points(double apart, int units = 0) {
  const double first = 1 - apart / 2;
  const double second = 1 + apart / 2;
  double then = 5 + 7.5 * (second - first);
  for (int i = 0; i < units; ++i) then = std::nextafter(then, 10.0);
  return Table(Domain::time, Interpolation::cubic_hermite, Extrapolation::hold,
               {{0, first, second, 2}, {0, 5, then, 10}, {0, 7.5, 7.5, 0}, {}});
}

/// An interval of one cycle of 1 ms, whose jerk may exceed the limit by 1 %, and one of a hundredth
/// of a cycle, whose mean may.
inline constexpr ShortInterval of_a_cycle{3600, 1e-3, 1000, 1e-7, 0.01};
inline constexpr ShortInterval of_a_part{60, 1e-5, 1, 4e-14, 1.0};

}  // namespace jounce::test
