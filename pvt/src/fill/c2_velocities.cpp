// SPDX-License-Identifier: Apache-2.0
#include "pvt/src/fill/c2_velocities.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <memory>
#include <vector>

// Piece i has the length h_i and the chord d_i. The acceleration is continuous at knot i if
//
//   (1)  h_i v_(i-1) + 2 (h_(i-1) + h_i) v_i + h_(i-1) v_(i+1) = 3 (h_i d_(i-1) + h_(i-1) d_i)
//
// Elimination in ascending order leaves v_i + c_i v_(i+1) = y_i with
//
//   (2)  c_i = h_(i-1) / D,  y_i = (3 (h_i d_(i-1) + h_(i-1) d_i) - h_i y_(i-1)) / D,
//        D = 2 (h_(i-1) + h_i) - h_i c_(i-1)
//
// with 0 <= c <= 1/2 (by induction: if c_(i-1) <= 1/2, then D >= 2 h_(i-1) + 1.5 h_i), so no pivots
// are needed.
//
// Each row waits for the division of the previous row. But errors fade along the chain. An error of
// y_(i-1) changes y_i by f_i = h_i / D = (1 - 2 c_i) / (2 - c_(i-1)) times the error. Because (1 -
// 2 c) / (2 - c) <= 1/2, the product of m such factors is at most 2^-m (times 2 at its ends). An
// error of c_(i-1) changes c_i by c_i f_i <= 1/12 times the error, and an error of v_(i+1) changes
// v_i by c_i <= 1/2 times the error. So a chain that starts with zeros 64 rows early gives the same
// result to 2^-63. Long tables are cut into four chains that are computed side by side.

namespace jounce::pvt_detail {
namespace {

constexpr std::size_t chains = 4;
constexpr std::size_t warm_up = 64;
constexpr std::size_t worth_cutting = 16 * warm_up;

/// The numbers that the elimination passes from row to row.
struct State {
  double c, y;  // from the previous row
  double h, d;  // from the previous piece
};

struct Knots {
  const double* x;
  const double* p;

  [[nodiscard]] State before(std::size_t row, EndRow end) const {
    const double h = x[row] - x[row - 1];
    return {end.ratio, end.value, h, (p[row] - p[row - 1]) / h};
  }

  /// Eliminates row i by (2).
  [[gnu::always_inline]] void eliminate(std::size_t i, State& s) const {
    const double h = x[i + 1] - x[i];
    const double d = (p[i + 1] - p[i]) / h;
    const double inverse = 1 / (2 * (s.h + h) - h * s.c);
    s.y = (3 * (h * s.d + s.h * d) - h * s.y) * inverse;
    s.c = s.h * inverse;
    s.h = h;
    s.d = d;
  }
};

/// Rows 1 to `rows` of a stretch, as chains of equal length; the last chain also has the remainder.
class Sweep {
 public:
  Sweep(Knots knots, std::size_t rows, double* c, double* v)
      : knots_(knots), rows_(rows), length_(rows / chains), c_(c), v_(v) {}

  void up(EndRow first) {
    if (rows_ < worth_cutting) return up(knots_.before(1, first), 1, rows_);
    std::array<State, chains> s;
    for (std::size_t k = 0; k < chains; ++k) s[k] = k == 0 ? knots_.before(1, first) : warm(k);
    for (std::size_t i = 1; i <= length_; ++i)
      for (std::size_t k = 0; k < chains; ++k) store(i + k * length_, s[k]);
    up(s.back(), chains * length_ + 1, rows_);
  }

  void down() {
    if (rows_ < worth_cutting) return down(v_[rows_ + 1], rows_, 1);
    down(v_[rows_ + 1], rows_, chains * length_ + 1);
    std::array<double, chains> next;
    for (std::size_t k = 0; k < chains; ++k) next[k] = next_of(k);
    for (std::size_t i = length_; i > 0; --i)
      for (std::size_t k = 0; k < chains; ++k) {
        const std::size_t row = i + k * length_;
        next[k] = v_[row] -= c_[row] * next[k];
      }
  }

 private:
  [[gnu::always_inline]] void store(std::size_t row, State& s) {
    knots_.eliminate(row, s);
    c_[row] = s.c;
    v_[row] = s.y;
  }

  void up(State s, std::size_t from, std::size_t to) {
    for (std::size_t i = from; i <= to; ++i) store(i, s);
  }

  void down(double next, std::size_t from, std::size_t to) {
    for (std::size_t i = from; i >= to; --i) next = v_[i] -= c_[i] * next;
  }

  /// An approximate state before the first row of chain k, which converges to the exact one.
  [[nodiscard]] State warm(std::size_t k) const {
    const std::size_t end = k * length_ + 1;
    State s = knots_.before(end - warm_up, {0, 0});
    for (std::size_t i = end - warm_up; i < end; ++i) knots_.eliminate(i, s);
    return s;
  }

  /// The velocity after the last row of chain k.
  [[nodiscard]] double next_of(std::size_t k) const {
    const std::size_t last = (k + 1) * length_;
    if (k + 1 == chains) return v_[last + 1];
    double next = 0;
    for (std::size_t i = last + warm_up; i > last; --i) next = v_[i] - c_[i] * next;
    return next;
  }

  Knots knots_;
  std::size_t rows_, length_;
  double* c_;
  double* v_;
};

}  // namespace

EndRow not_a_knot_end(double h0, double chord0, double h1, double chord1) {
  // C. de Boor, ch. IV (12): the third derivative is continuous; v_2 is eliminated by (1).
  const double both = h0 + h1;
  return {both / h1, ((h0 + 2 * both) * h1 * chord0 + h0 * h0 * chord1) / (both * h1)};
}

void c2_velocities(std::span<const double> x, std::span<const double> p, EndRow first, EndRow last,
                   std::span<double> v) {
  assert(x.size() >= 2 && p.size() == x.size() && v.size() == x.size());
  const std::size_t end = x.size() - 1;
  const auto c = std::make_unique_for_overwrite<double[]>(end);
  Sweep sweep({x.data(), p.data()}, end - 1, c.get(), v.data());
  c[0] = first.ratio;
  v[0] = first.value;
  sweep.up(first);
  v[end] = (last.value - last.ratio * v[end - 1]) / (1 - last.ratio * c[end - 1]);
  sweep.down();
  v[0] -= c[0] * v[1];
}

// The velocities are u + t z: u with ends at rest, z the response to t = 1 at both ends.
// At the joint of two periods, (1) is linear in t.
void c2_periodic_velocities(std::span<const double> x, std::span<const double> p,
                            std::span<double> v) {
  const std::size_t end = x.size() - 1;
  std::vector<double> response(x.size()), level(x.size(), 0.0);
  c2_velocities(x, p, given_end(0), given_end(0), v);
  c2_velocities(x, level, given_end(1), given_end(1), response);
  const double h0 = x[end] - x[end - 1], h1 = x[1] - x[0];
  const double d0 = (p[end] - p[end - 1]) / h0, d1 = (p[1] - p[0]) / h1;
  const double left = 3 * (h1 * d0 + h0 * d1) - h1 * v[end - 1] - h0 * v[1];
  const double t = left / (2 * (h0 + h1) + h1 * response[end - 1] + h0 * response[1]);
  for (std::size_t i = 0; i <= end; ++i) v[i] += t * response[i];
  v[end] = v[0];
}

}  // namespace jounce::pvt_detail
