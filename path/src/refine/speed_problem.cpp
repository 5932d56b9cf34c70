// SPDX-License-Identifier: Apache-2.0
#include "path/src/refine/speed_problem.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include "jounce/profiles/detail/numeric.hpp"

// Over a cell of length h in which B is linear from a = u^2 to b = w^2, the duration and its
// derivatives are
//
//   (1)  f = 2 h / (u + w),   f_a = -h / ((u + w)^2 u),
//        f_aa = h (1 / ((u + w)^3 u^2) + 1 / (2 (u + w)^2 u^3)),   f_ab = h / ((u + w)^3 u w)
//
// With the slacks s = 1 - c B and s = low + c B of the rows, and s = most - B of the nodes, and
// multipliers m > 0, one step of the method solves
//
//   (2)  (f'' + sum of m / s c c') dB = -(f' + sum of mu / s c),   dm = mu / s - m - (m / s) ds
//
// A row has three successive nodes, so the matrix has two diagonals beside the main one. The sum of
// m s bounds the distance to the least duration.

namespace jounce {
namespace {

using profiles_detail::square;

constexpr int most_steps = 60;
constexpr double centering = 0.15;    ///< factor of the complementarity in each step
constexpr double to_boundary = 0.99;  ///< share of the way to the nearest limit
constexpr double shortest_step = 1e-6;

/// A symmetric matrix with two diagonals beside the main one.
struct Banded {
  std::vector<double> d0, d1, d2;

  explicit Banded(std::size_t n) : d0(n), d1(n), d2(n) {}

  void clear() {
    for (auto* d : {&d0, &d1, &d2}) std::fill(d->begin(), d->end(), 0.0);
  }

  /// Solves A x = x in place, by A = L D L'. Destroys the matrix.
  void solve(std::vector<double>& x) {
    const std::size_t n = d0.size();
    for (std::size_t i = 0; i < n; ++i) {
      const double pivot = 1 / d0[i];
      const double l1 = d1[i] * pivot;
      const double l2 = d2[i] * pivot;
      if (i + 1 < n) {
        d0[i + 1] -= l1 * d1[i];
        d1[i + 1] -= l1 * d2[i];
        x[i + 1] -= l1 * x[i];
      }
      if (i + 2 < n) {
        d0[i + 2] -= l2 * d2[i];
        x[i + 2] -= l2 * x[i];
      }
      d1[i] = l1;
      d2[i] = l2;
      x[i] *= pivot;
    }
    for (std::size_t i = n; i-- > 0;) {
      if (i + 1 < n) x[i] -= d1[i] * x[i + 1];
      if (i + 2 < n) x[i] -= d2[i] * x[i + 2];
    }
  }
};

/// Multiplier and slack of one limit.
struct Pair {
  double m = 0, s = 0;
};

class InteriorPoint {
 public:
  InteriorPoint(const SpeedProblem& problem, std::vector<double> b)
      : p_(problem),
        b_(std::move(b)),
        up_(p_.rows.size()),
        down_(p_.rows.size()),
        top_(b_.size()),
        matrix_(b_.size()),
        step_(b_.size()) {}

  std::vector<double> run(double gap) {
    const double count = static_cast<double>(2 * p_.rows.size() + b_.size());
    set_slacks();
    double mu = 0.1 * p_.duration(b_) / count;
    each_pair([&](Pair& pair) { pair.m = mu / pair.s; });
    for (int i = 0; i < most_steps; ++i) {
      double complementarity = 0;
      each_pair([&](const Pair& pair) { complementarity += pair.m * pair.s; });
      const double residual = dual_residual();
      const double allowed = gap * p_.duration(b_);
      if (complementarity <= allowed && residual <= allowed) break;
      mu = (residual > complementarity ? 1 : centering) * complementarity / count;
      assemble(mu);
      matrix_.solve(step_);
      if (take(mu) < shortest_step) break;
    }
    return b_;
  }

 private:
  template <class Act>
  void each_pair(Act act) {
    for (auto* pairs : {&up_, &down_}) std::for_each(pairs->begin(), pairs->end(), act);
    std::for_each(top_.begin() + 1, top_.end() - 1, act);
  }

  static double dot(const SpeedRow& row, const std::vector<double>& x) {
    const double* at = x.data() + row.first;
    return row.c[0] * at[0] + row.c[1] * at[1] + row.c[2] * at[2];
  }

  void set_slacks() {
    for (std::size_t i = 0; i < p_.rows.size(); ++i) {
      const double x = dot(p_.rows[i], b_);
      up_[i].s = 1 - x;
      down_[i].s = p_.rows[i].low + x;
    }
    for (std::size_t k = 0; k < b_.size(); ++k) top_[k].s = p_.most[k] - b_[k];
  }

  /// Calls act(k, f') for both ends k of each cell.
  template <class Act>
  void each_slope(Act act) const {
    const std::size_t last = b_.size() - 1;
    for (std::size_t k = 0; k < last; ++k) {
      const double u = std::sqrt(b_[k]);
      const double w = std::sqrt(b_[k + 1]);
      const double pull = p_.cells[k] / square(u + w);
      if (k > 0) act(k, -pull / u);
      if (k + 1 < last) act(k + 1, -pull / w);
    }
  }

  /// The distance of f' + sum of m c from 0, as a time: each component times B.
  double dual_residual() {
    std::vector<double>& sum = step_;
    std::fill(sum.begin(), sum.end(), 0.0);
    each_slope([&](std::size_t k, double slope) { sum[k] += slope; });
    for (std::size_t i = 0; i < p_.rows.size(); ++i)
      for (std::size_t m = 0; m < 3; ++m)
        sum[p_.rows[i].first + m] += (up_[i].m - down_[i].m) * p_.rows[i].c[m];
    double time = 0;
    for (std::size_t k = 1; k + 1 < b_.size(); ++k) time += std::abs(sum[k] + top_[k].m) * b_[k];
    return time;
  }

  /// The system (2); the right-hand side is in step_.
  void assemble(double mu) {
    matrix_.clear();
    std::fill(step_.begin(), step_.end(), 0.0);
    each_slope([&](std::size_t k, double slope) { step_[k] -= slope; });
    const std::size_t last = b_.size() - 1;
    for (std::size_t k = 0; k < last; ++k) {
      const double h = p_.cells[k];
      const double u = std::sqrt(b_[k]);
      const double w = std::sqrt(b_[k + 1]);
      const double sum = u + w;
      const double cube = profiles_detail::cube(sum);
      if (k > 0) matrix_.d0[k] += h * (1 / (cube * u * u) + 0.5 / (sum * sum * u * u * u));
      if (k + 1 < last)
        matrix_.d0[k + 1] += h * (1 / (cube * w * w) + 0.5 / (sum * sum * w * w * w));
      if (k > 0 && k + 1 < last) matrix_.d1[k] += h / (cube * u * w);
    }
    for (std::size_t i = 0; i < p_.rows.size(); ++i) {
      const SpeedRow& row = p_.rows[i];
      const std::size_t k = row.first;
      const auto& c = row.c;
      const double pull = mu / up_[i].s - mu / down_[i].s;
      const double stiff = up_[i].m / up_[i].s + down_[i].m / down_[i].s;
      for (std::size_t m = 0; m < 3; ++m) {
        step_[k + m] -= pull * c[m];
        matrix_.d0[k + m] += stiff * c[m] * c[m];
      }
      matrix_.d1[k] += stiff * c[0] * c[1];
      matrix_.d1[k + 1] += stiff * c[1] * c[2];
      matrix_.d2[k] += stiff * c[0] * c[2];
    }
    for (std::size_t k = 1; k < last; ++k) {
      step_[k] -= mu / top_[k].s;
      matrix_.d0[k] += top_[k].m / top_[k].s;
    }
    for (const std::size_t end : {std::size_t{0}, last}) {  // B is 0 there
      step_[end] = 0;
      matrix_.d0[end] = 1;
      matrix_.d1[end] = matrix_.d2[end] = 0;
    }
    matrix_.d1[last - 1] = 0;
    matrix_.d2[last - 2] = 0;
  }

  /// Takes the longest step within all limits; returns its share of the whole step.
  double take(double mu) {
    double share = 1 / to_boundary;
    const auto limit = [&](double value, double change) {
      if (change < 0) share = std::min(share, value / -change);
    };
    // ds of a pair; dm by (2).
    const auto bound = [&](const Pair& pair, double ds) {
      limit(pair.s, ds);
      limit(pair.m, (mu - pair.m * ds) / pair.s - pair.m);
    };
    const auto each = [&](auto act) {
      for (std::size_t i = 0; i < p_.rows.size(); ++i) {
        const double x = dot(p_.rows[i], step_);
        act(up_[i], -x);
        act(down_[i], x);
      }
      for (std::size_t k = 1; k + 1 < b_.size(); ++k) act(top_[k], -step_[k]);
    };
    each(bound);
    for (std::size_t k = 1; k + 1 < b_.size(); ++k) limit(b_[k], step_[k]);
    share *= to_boundary;
    each([&](Pair& pair, double ds) { pair.m += share * ((mu - pair.m * ds) / pair.s - pair.m); });
    for (std::size_t k = 0; k < b_.size(); ++k) b_[k] += share * step_[k];
    set_slacks();
    return share;
  }

  const SpeedProblem& p_;
  std::vector<double> b_;
  std::vector<Pair> up_, down_, top_;
  Banded matrix_;
  std::vector<double> step_;
};

}  // namespace

double SpeedProblem::duration(const std::vector<double>& b) const {
  double time = 0;
  for (std::size_t k = 0; k < cells.size(); ++k)
    time += 2 * cells[k] / (std::sqrt(b[k]) + std::sqrt(b[k + 1]));
  return time;
}

double SpeedProblem::use(const std::vector<double>& b) const {
  double most_used = 0;
  for (const SpeedRow& row : rows) {
    const double x =
        row.c[0] * b[row.first] + row.c[1] * b[row.first + 1] + row.c[2] * b[row.first + 2];
    most_used = std::max({most_used, x, -x / row.low});
  }
  for (std::size_t k = 1; k + 1 < b.size(); ++k) most_used = std::max(most_used, b[k] / most[k]);
  return most_used;
}

std::vector<double> fastest_speeds(const SpeedProblem& problem, std::vector<double> b, double gap) {
  return InteriorPoint(problem, std::move(b)).run(gap);
}

}  // namespace jounce
