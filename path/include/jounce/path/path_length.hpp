// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "jounce/path/plan.hpp"
#include "jounce/profiles/curve/fitted.hpp"
#include "jounce/profiles/curve/over_length.hpp"

namespace jounce {

/// The length along the path as a function of the path parameter q. Length and q are equal on lines
/// and arcs. On a rounded corner, q counts the two ends of the sides that the corner replaces, and
/// the path is shorter. On a spline, q is the length within a tolerance.
///
///     const PathLength length(motion);                 // motion: a Plan
///     length.whole();                                  // u
///     length.at(motion.law().at(t).position).length;   // from the start of the path to time t
///
/// The length is the integral of |r'|, r the position of the path axes. |r'| is replaced by
/// polynomials with a proven error, at most 1e-10 of the length of corners and curves. Along a
/// command that moves only followers, the length counts q. The plan need not outlive the object.
class PathLength {
 public:
  /// Takes time and memory in proportion to the number of corners and curves.
  explicit PathLength(const Plan& plan);

  struct Place {
    double length = 0;  ///< u, from the start of the path
    double slope = 1;   ///< length per q
  };
  /// The place at q, from 0 to the length of the path in q. Does not allocate; its time grows with
  /// the logarithm of the number of corners.
  [[nodiscard]] Place at(double q) const noexcept;
  /// Returns the whole length, u.
  [[nodiscard]] double whole() const { return end_.length; }
  /// Returns a bound of the error of each length, u, without rounding.
  [[nodiscard]] double error() const { return error_; }
  /// Returns the length as a curve over q.
  [[nodiscard]] Curve<OverLength> curve() const;

 private:
  static constexpr std::size_t numbers = Segment::max_degree + 1;

  /// A part of the path: a polynomial of q, or at slope 1.
  struct Part {
    double start = 0;   // q at its start
    double before = 0;  // length of the path up to there
    double extent = 0;  // in q
    bool plain = true;
    std::size_t first = 0;  // index of its first coefficient
  };
  void add_plain(double extent);
  void add_curved(std::span<const Segment> axes, double extent, double tolerance);
  void add_polynomial(std::span<const double, numbers - 1> speed, double extent);
  void append(Part part, double length);

  std::vector<Part> parts_;
  std::vector<double> coefficients_;
  double error_ = 0;
  struct {
    double q = 0, length = 0;
  } end_;
};

/// Returns the length along the path over time, from 0 s, with a bound of its error. Where the
/// velocity is constant, or the path is a line or an arc, the only error is PathLength::error().
Fitted<OverTime> length_over_time(const Plan& plan);

}  // namespace jounce
