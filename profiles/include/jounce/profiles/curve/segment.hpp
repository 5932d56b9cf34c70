// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>

#include "jounce/profiles/curve/jet.hpp"

namespace jounce {

/// amplitude * sin(angle * s + phase), s in [0, 1] over the segment; angle and phase in rad.
struct SineTerm {
  double amplitude = 0;
  double angle = 0;
  double phase = 0;
};

/// One piece of a curve: a polynomial and a few sine terms over a length.
///
///     f(s) = c[0] + c[1] s + ... + c[degree] s^degree + sum of sine terms,   s = u / length
///
/// u is the distance from the segment's start in the unit of the axis below (s, deg, pulse, ...);
/// every coefficient is in the unit of the value. Stretching a segment changes `length` alone.
/// The capacity (degree 11, three sines) makes every profile and every classical cam law exact;
/// only the degree in use is evaluated. The set is closed under derivative, shift, scale, reversal
/// and sub-interval; `sum` returns nothing if the result no longer fits.
struct Segment {
  static constexpr int max_degree = 11;
  static constexpr int max_sines = 3;

  double length = 1;  ///< > 0, finite
  int degree = 0;
  int sines = 0;
  std::array<double, max_degree + 1> c{};  ///< zero above degree
  std::array<SineTerm, max_sines> sine{};
};

/// Value and three derivatives by u at s in [0, 1].
Jet evaluate(const Segment& f, double s);

/// The value alone.
double value(const Segment& f, double s);

/// df/du. Exact; the degree falls by one, sines stay sines.
Segment derivative(const Segment& f);

/// The integral that starts at `start_value`; nothing if the degree would pass max_degree.
std::optional<Segment> integral(const Segment& f, double start_value);

/// g(u) = f(length - u).
Segment reversed(const Segment& f);

/// The piece between s0 < s1 as a segment of its own; outside [0, 1] the formula goes on.
Segment part(const Segment& f, double s0, double s1);

/// g = factor * f + offset.
Segment scaled(const Segment& f, double factor, double offset = 0);

/// f + g, which have the same length. Sines of one frequency are merged; nothing if more than
/// max_sines remain.
std::optional<Segment> sum(const Segment& f, const Segment& g);

/// Upper bound of |f| over the segment (sum of the magnitudes of all terms): the scale that
/// rounding is measured against.
double magnitude(const Segment& f);

/// The segment of degree 3, resp. 5, through the values at both ends: Hermite interpolation.
/// p in the value's unit, v and a its derivatives by u.
Segment cubic(double length, double p0, double v0, double p1, double v1);
Segment quintic(double length, double p0, double v0, double a0, double p1, double v1, double a1);

/// The straight line from p0 to p1.
Segment line(double length, double p0, double p1);

}  // namespace jounce
