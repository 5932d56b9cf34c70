// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "jounce/optimize/shape.hpp"
#include "jounce/profiles/curve/extrema.hpp"
#include "jounce/profiles/curve/segment.hpp"

#include "optimize/src/solvers/interior_point.hpp"

/// All splines over given knots, as a linear space whose coordinates remain well conditioned.
///
/// With n the degree, S_ij the size of derivative j on piece i and d the offset of the values, the
/// coordinates are the derivatives at the beginning of each piece, and at the end of the last one:
///
///     (1)  z[i (n + 1) + j] = (f^(j)(x_i+) - [j = 0] d) / S_ij,    j = 0 ... n  (at the end: ... n - 1)
///     (2)  f^(j)(x_i+1) = sum_k f^(k)(x_i+) h_i^(k - j) / (k - j)!,    j = 0 ... n - 1
///     (3)  S_ij = 4^(j-1) (j-1)! u / L^j up to the highest derivative m that matters, as a perfect spline
///          has; S_im / h_i^(j-m) above it: what a piece can do to that derivative
///
/// There are more coordinates than degrees of freedom. The equalities (2) relate them. Each
/// contains two adjacent knots only: all matrices remain banded, and a short piece is as well
/// conditioned as a long one. (Coefficients of B-splines lose a factor 1/h in every derivative: at
/// n = 5 and h = 1/1000 all digits.)
namespace jounce::optimize_detail {

using Coordinates = std::vector<double>;

/// Knots closer together than this share of the length of a piece are one knot.
constexpr double same_knot = 1e-6;

/// Returns the order of the highest derivative in q; -1 if q is constant.
int order_of(const LinearQuantity& q);

/// Returns q for one segment, as a segment.
Segment quantity_of(const LinearQuantity& q, const Segment& f);

class SplineSpace {
 public:
  /// `size`: size of the values, u, > 0. `knots` ascend, at least two. `order`: m of (3).
  SplineSpace(std::vector<double> knots, int degree, int order, double size, double offset);

  [[nodiscard]] int degree() const { return degree_; }
  [[nodiscard]] std::size_t pieces() const { return knots_.size() - 1; }
  [[nodiscard]] std::span<const double> knots() const { return knots_; }
  [[nodiscard]] double length(std::size_t piece) const { return knots_[piece + 1] - knots_[piece]; }
  /// Number of coordinates. Further unknowns of a program come after them.
  [[nodiscard]] std::size_t size() const { return pieces() * stride() + stride() - 1; }
  /// Returns the index of the coordinate f^(order) at the beginning of a piece; for piece ==
  /// pieces(), at the end (order < degree).
  [[nodiscard]] std::size_t index(std::size_t piece, int order) const {
    return piece * stride() + static_cast<std::size_t>(order);
  }
  /// Returns S of (3); for piece == pieces(), at the end.
  [[nodiscard]] double unit(std::size_t piece, int order) const {
    return units_[index(piece, order)];
  }
  /// Returns the size of q in a perfect spline: the sum of |by[k]| S_k, with (3) for all
  /// derivatives.
  [[nodiscard]] double natural(const LinearQuantity& q) const;
  /// Returns the index of the piece that contains x; at a knot, the piece that begins at the knot.
  [[nodiscard]] std::size_t piece_at(double x) const;

  /// Returns q at s in [0, 1] of a piece, exactly.
  [[nodiscard]] Form at(const LinearQuantity& q, std::size_t piece, double s) const;
  /// Returns the j-th derivative of q at the beginning of a piece.
  [[nodiscard]] Form derivative_at(const LinearQuantity& q, std::size_t piece, int j) const;
  /// Returns squares whose sum is the integral of q^2, exactly (Gauss's rule with degree + 1 places
  /// for each piece).
  [[nodiscard]] std::vector<Form> squares(const LinearQuantity& q) const;

  /// Returns the equalities (2), each == 0.
  [[nodiscard]] std::vector<Form> joints() const;
  /// Returns the equalities for the fixed values at the ends, each == 0. `periodic`: derivatives
  /// are equal at both ends.
  [[nodiscard]] std::vector<Form> ends(const ShapeEnd& from, const ShapeEnd& to,
                                       bool periodic) const;

  /// Returns the spline with these coordinates, from the first knot on.
  [[nodiscard]] std::vector<Segment> segments(const Coordinates& z) const;
  /// Returns the coordinates of a shape over the same interval: its derivatives at the knots, and
  /// the mean of the highest derivative. They are exact for a spline over these knots.
  [[nodiscard]] Coordinates coordinates(const std::vector<Segment>& shape) const;

  /// Returns z with all coordinates computed again by (2), except for the highest derivatives and
  /// the derivatives at the beginning. The result is a spline for any z. The coordinates that are
  /// kept are a basis of the space.
  [[nodiscard]] Coordinates propagated(Coordinates z) const;
  /// True if a coordinate belongs to that basis.
  [[nodiscard]] bool independent(std::size_t coordinate) const {
    return coordinate < stride() || coordinate % stride() == stride() - 1;
  }

 private:
  [[nodiscard]] std::size_t stride() const { return static_cast<std::size_t>(degree_) + 1; }

  std::vector<double> knots_;
  int degree_;
  double offset_;
  std::array<double, 12> sizes_{};
  std::vector<double> units_;
};

/// Returns the fixed values at an end, by order; nullopt: free.
std::array<std::optional<double>, 5> derivatives_of(const ShapeEnd& end);

}  // namespace jounce::optimize_detail
