// SPDX-License-Identifier: Apache-2.0
#include "pvt/src/fill/least_jerk.hpp"

#include <vector>

// The quintic piece of length h with the end states (p0, v0, a0, p1, v1, a1) has, with d = p1 - p0
// and u = (v0 h, a0 h^2, v1 h, a1 h^2),
//
//   (1)  integral of jerk^2 = (720 d^2 - 2 d g' u + u' K u) / h^5
//
//        g = (360, 60, 360, -60),   K = ( 192   36  168  -24 )
//                                       (  36    9   24   -3 )
//                                       ( 168   24  192  -36 )
//                                       ( -24   -3  -36    9 )
//
// (`cam/src/design/least_energy.cpp` has the matrix for free positions as well, which smoothing
// splines need. Here the positions are given, and the remaining 2 x 2 blocks need no library.) The
// sum over all pieces is least if its gradient with respect to every free state vanishes. This is a
// positive definite system in which the two states x_i of a knot are coupled only to those of its
// neighbors. The first knot of a periodic table is a border, which is eliminated last:
//
//   (2)  N_(i-1)' x_(i-1) + D_i x_i + N_i x_(i+1) + B_i x_0 = r_i
//
// A fixed state is the equation 1 * x = value; its column is moved to the right side. The system is
// positive definite, so it needs no pivots at any scale of the unknowns. The unit of length is the
// mean piece.

namespace jounce::pvt_detail {
namespace {

using Vector = std::array<double, 2>;
using Matrix = std::array<double, 4>;  // row by row

constexpr Matrix transposed(const Matrix& m) {
  return {m[0], m[2], m[1], m[3]};
}
constexpr Vector operator*(const Matrix& m, const Vector& x) {
  return {m[0] * x[0] + m[1] * x[1], m[2] * x[0] + m[3] * x[1]};
}
constexpr Matrix operator*(const Matrix& a, const Matrix& b) {
  return {a[0] * b[0] + a[1] * b[2], a[0] * b[1] + a[1] * b[3], a[2] * b[0] + a[3] * b[2],
          a[2] * b[1] + a[3] * b[3]};
}
template <std::size_t n>
constexpr void subtract(std::array<double, n>& a, const std::array<double, n>& b) {
  for (std::size_t k = 0; k < n; ++k) a[k] -= b[k];
}
template <std::size_t n>
constexpr void add(std::array<double, n>& a, const std::array<double, n>& b) {
  for (std::size_t k = 0; k < n; ++k) a[k] += b[k];
}

/// The inverse of a symmetric positive definite matrix; Cholesky's Schur complement keeps its sign.
Matrix inverse(const Matrix& m) {
  const double ratio = m[1] / m[0];
  const double schur = m[3] - ratio * m[1];
  const double off = -ratio / schur;
  return {1 / m[0] - off * ratio, off, off, 1 / schur};
}

/// The contribution of one piece to (2): half of the gradient of (1).
struct Element {
  Matrix first, coupling, second;
  Vector right_first, right_second;

  Element(double h, double d, const JerkKnot& a, const JerkKnot& b) {
    const double i1 = 1 / h, i2 = i1 * i1, i3 = i2 * i1, i4 = i2 * i2;
    first = {192 * i3, 36 * i2, 36 * i2, 9 * i1};
    second = {192 * i3, -36 * i2, -36 * i2, 9 * i1};
    coupling = {168 * i3, -24 * i2, 24 * i2, -3 * i1};
    const double scaled = d * i4;
    right_first = {360 * scaled, 60 * scaled * h};
    right_second = {360 * scaled, -60 * scaled * h};
    for (std::size_t k = 0; k < 2; ++k) {
      if (a.fixed[k]) fix(k, a.state[k], first, coupling, right_first, right_second);
      if (b.fixed[k]) {
        coupling = transposed(coupling);
        fix(k, b.state[k], second, coupling, right_second, right_first);
        coupling = transposed(coupling);
      }
    }
  }

 private:
  /// Fixes state k of the knot with the block `own` to `value`; `to_other` is its coupling, by
  /// rows.
  static void fix(std::size_t k, double value, Matrix& own, Matrix& to_other, Vector& right,
                  Vector& other_right) {
    const std::size_t j = 1 - k;
    right[j] -= own[2 * j + k] * value;
    for (std::size_t n = 0; n < 2; ++n) {
      other_right[n] -= to_other[2 * k + n] * value;
      to_other[2 * k + n] = 0;
    }
    own[1] = own[2] = 0;
    own[3 * k] = 0;
    right[k] = 0;
  }
};

/// One row of (2), for one knot.
struct Row {
  Matrix diagonal{}, next{}, border{};
  Vector right{};
};

class System {
 public:
  System(std::span<const double> x, std::span<const double> p, bool periodic,
         std::span<const JerkKnot> knots)
      : rows_(x.size() - (periodic ? 1 : 0)),
        unit_((x.back() - x.front()) / static_cast<double>(x.size() - 1)) {
    for (std::size_t i = 0; i + 1 < x.size(); ++i) {
      const std::size_t j = i + 1 < rows_.size() ? i + 1 : i + 1 - rows_.size();
      add_piece(i, j,
                Element((x[i + 1] - x[i]) / unit_, p[i + 1] - p[i], in_units(knots[i]),
                        in_units(knots[i + 1])));
    }
    for (std::size_t i = 0; i < rows_.size(); ++i)
      for (std::size_t k = 0; k < 2; ++k)
        if (knots[i].fixed[k]) {
          rows_[i].diagonal[3 * k] = 1;
          rows_[i].right[k] = in_units(knots[i]).state[k];
        }
  }

  /// Returns the solution, in the units of x.
  std::vector<Vector> solve() {
    for (std::size_t i = 1; i < rows_.size(); ++i) eliminate(i);
    std::vector<Vector> states(rows_.size());
    states[0] = inverse(rows_[0].diagonal) * rows_[0].right;
    for (std::size_t i = rows_.size(); --i > 0;) {
      states[i] = rows_[i].right;
      subtract(states[i], rows_[i].border * states[0]);
      if (i + 1 < rows_.size()) subtract(states[i], rows_[i].next * states[i + 1]);
    }
    for (Vector& s : states) s = {s[0] / unit_, s[1] / (unit_ * unit_)};
    return states;
  }

 private:
  [[nodiscard]] JerkKnot in_units(JerkKnot knot) const {
    knot.state = {knot.state[0] * unit_, knot.state[1] * unit_ * unit_};
    return knot;
  }

  void add_piece(std::size_t i, std::size_t j, const Element& e) {
    add(rows_[i].diagonal, e.first);
    add(rows_[i].right, e.right_first);
    add(rows_[j].diagonal, e.second);
    add(rows_[j].right, e.right_second);
    if (i == 0 && j == 0) {
      add(rows_[0].diagonal, e.coupling);
      add(rows_[0].diagonal, transposed(e.coupling));
    } else if (i == 0) {
      add(rows_[j].border, transposed(e.coupling));
    } else if (j == 0) {
      add(rows_[i].border, e.coupling);
    } else {
      rows_[i].next = e.coupling;
    }
  }

  /// Eliminates x_i from the rows i + 1 and 0; stores it as a function of their unknowns.
  void eliminate(std::size_t i) {
    Row& row = rows_[i];
    const Matrix inverted = inverse(row.diagonal);
    const Row solved{{}, inverted * row.next, inverted * row.border, inverted * row.right};
    const Matrix border = transposed(row.border);
    subtract(rows_[0].diagonal, border * solved.border);
    subtract(rows_[0].right, border * solved.right);
    if (i + 1 < rows_.size()) {
      const Matrix next = transposed(row.next);
      subtract(rows_[i + 1].diagonal, next * solved.next);
      subtract(rows_[i + 1].border, next * solved.border);
      subtract(rows_[i + 1].right, next * solved.right);
    }
    row = solved;
  }

  std::vector<Row> rows_;
  double unit_;
};

/// Copies a fixed state from one end of a periodic table to the other.
void close(JerkKnot& first, JerkKnot& last) {
  for (std::size_t k = 0; k < 2; ++k) {
    (first.fixed[k] ? last : first).state[k] = (first.fixed[k] ? first : last).state[k];
    first.fixed[k] = last.fixed[k] = first.fixed[k] || last.fixed[k];
  }
}

/// True if no state is given that selects one of the parabolas through two points, all of which
/// have no jerk. Then the straight line is chosen: it has no acceleration.
bool undetermined(std::span<const JerkKnot> knots) {
  if (knots.size() > 2) return false;
  for (const JerkKnot& knot : knots)
    if (knot.fixed[0] || knot.fixed[1]) return false;
  return true;
}

}  // namespace

void least_jerk(std::span<const double> x, std::span<const double> p, bool periodic,
                std::span<JerkKnot> knots) {
  if (periodic) close(knots.front(), knots.back());
  if (undetermined(knots)) {
    for (JerkKnot& knot : knots) knot.state = {(p[1] - p[0]) / (x[1] - x[0]), 0};
    return;
  }
  const std::vector<Vector> found = System(x, p, periodic, knots).solve();
  for (std::size_t i = 0; i < knots.size(); ++i)
    for (std::size_t k = 0; k < 2; ++k)
      if (!knots[i].fixed[k]) knots[i].state[k] = found[i < found.size() ? i : 0][k];
}

}  // namespace jounce::pvt_detail
