// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>

namespace jounce::pvt_detail {

/// A condition on the velocity at one end of a stretch and on the next one: v_end + ratio v_next =
/// value.
struct EndRow {
  double ratio = 0;
  double value = 0;
};

/// The condition that v_end has this value.
constexpr EndRow given_end(double velocity) {
  return {0, velocity};
}

/// The condition that the acceleration is zero at the end of a piece with this chord.
constexpr EndRow natural_end(double chord) {
  return {0.5, 1.5 * chord};
}

/// The condition that one cubic extends over the piece at the end (length h0) and the next one
/// (length h1).
EndRow not_a_knot_end(double h0, double chord0, double h1, double chord1);

/// Sets the velocities of the cubic spline through knots (x, p) whose acceleration is continuous at
/// all inner knots. Spans of equal size >= 2.
void c2_velocities(std::span<const double> x, std::span<const double> p, EndRow first, EndRow last,
                   std::span<double> v);

/// The same for a periodic table, whose last knot is the first one of the next period.
void c2_periodic_velocities(std::span<const double> x, std::span<const double> p,
                            std::span<double> v);

}  // namespace jounce::pvt_detail
