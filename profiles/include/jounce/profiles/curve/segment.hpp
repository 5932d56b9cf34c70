// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>

#include "jounce/profiles/curve/jet.hpp"

namespace jounce {

/// A sine term: amplitude * sin(angle * s + phase), where s in [0, 1] is the position in the
/// segment.
struct SineTerm {
  double amplitude = 0;  ///< in the unit of the value
  double angle = 0;      ///< rad over the whole segment
  double phase = 0;      ///< rad at s = 0
};

/// One piece of a curve: a polynomial and up to three sine terms over a length.
///
///     f(s) = c[0] + c[1] s + ... + c[degree] s^degree + sum of sine terms,   s = u / length
///
/// u is the distance from the start of the segment, in the unit of the curve's variable (s, deg,
/// pulse, ...). Every coefficient is in the unit of the value, so stretching a segment changes only
/// `length`. With degree 11 and three sines, every profile and every classical cam law is exact.
/// Evaluation costs only the degree in use. Derivatives, parts, and shifted, scaled and reversed
/// segments are segments again. sum() and integral() return std::nullopt if the result does not
/// fit.
struct Segment {
  static constexpr int max_degree = 11;  ///< greatest degree of the polynomial
  static constexpr int max_sines = 3;    ///< greatest number of sine terms

  double length = 1;                       ///< > 0, finite
  int degree = 0;                          ///< degree of the polynomial, 0 to max_degree
  int sines = 0;                           ///< number of sine terms, 0 to max_sines
  std::array<double, max_degree + 1> c{};  ///< coefficients; zero above the degree
  std::array<SineTerm, max_sines> sine{};  ///< the first `sines` are used
};

/// Returns the value and three derivatives with respect to u, at s in [0, 1].
Jet evaluate(const Segment& f, double s);

/// Returns the value at s.
double value(const Segment& f, double s);

/// Returns the derivative with respect to u. Exact: the degree falls by one, sines stay sines.
Segment derivative(const Segment& f);

/// Returns the integral over u, which has the value `start_value` at u = 0. Returns std::nullopt if
/// the degree would exceed max_degree.
std::optional<Segment> integral(const Segment& f, double start_value);

/// Returns the segment backwards: g(u) = f(length - u).
Segment reversed(const Segment& f);

/// Returns the part from s0 to s1 as a segment. Requires s0 < s1. Outside [0, 1] the formula
/// continues.
Segment part(const Segment& f, double s0, double s1);

/// Returns g = factor * f + offset.
Segment scaled(const Segment& f, double factor, double offset = 0);

/// Returns f + g. Requires segments of the same length. Sines of the same frequency are merged.
/// Returns std::nullopt if more than max_sines remain.
std::optional<Segment> sum(const Segment& f, const Segment& g);

/// Returns an upper bound of |f| over the segment: the sum of the magnitudes of all terms. Rounding
/// errors are proportional to this bound.
double magnitude(const Segment& f);

/// Return the segment of degree 3 (cubic) or 5 (quintic) with the given values at its ends (Hermite
/// interpolation). p is the value; v and a are its first and second derivative with respect to u.
Segment cubic(double length, double p0, double v0, double p1, double v1);
Segment quintic(double length, double p0, double v0, double a0, double p1, double v1, double a1);

/// Returns the straight line from p0 to p1 over the given length.
Segment line(double length, double p0, double p1);

}  // namespace jounce
