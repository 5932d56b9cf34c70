// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include <Eigen/Cholesky>

#include "optimize/src/knots/bound.hpp"
#include "optimize/src/shapes/shape_report.hpp"

// Let g = f^(n), L the length, d the displacement, and r_j, j = 0 ... n - 1, the difference at the
// end between f^(j) and its Taylor polynomial from the beginning. Then
//
//   (1)  integral of (L - x)^(n-1-j) / (n-1-j)! g(x) dx = r_j,
//
// The moments of g are therefore known. The least integral of g^2 is that of the polynomial of
// degree n - 1 with these moments. With x = L (1 - s) and Hilbert's matrix H_ik = 1 / (i + k + 1)
//
//   (2)  integral of g^2 = L m' H^-1 m,   m_i = i! r_(n-1-i) / L^(i+1).
//
// The least max |g| from rest to rest (all derivatives up to n - 1 zero at both ends) is that of the
// perfect spline, which switches at the extrema of Chebyshev's polynomial:
//
//   (3)  max |g| = 2^(2n-2) (n-1)! |d| / L^n.
//
// For n = 2 and 3 with any ends see jounce/optimize/bound.hpp.

namespace jounce::optimize_detail {
namespace {

using Ends = std::array<std::optional<double>, 5>;

double factorial(int k) {
  return std::tgamma(k + 1.0);
}

bool all_given(const Ends& end, int n) {
  for (int j = 0; j < n; ++j)
    if (static_cast<std::size_t>(j) >= end.size() || !end[static_cast<std::size_t>(j)])
      return false;
  return true;
}

/// (2), per length.
double least_mean_square(const Ends& from, const Ends& to, int n, double length) {
  Eigen::VectorXd m(n);
  Eigen::MatrixXd hilbert(n, n);
  for (int i = 0; i < n; ++i) {
    const int j = n - 1 - i;
    double rest = *to[static_cast<std::size_t>(j)];
    double power = 1;
    for (int k = j; k < n; ++k, power *= length)
      rest -= *from[static_cast<std::size_t>(k)] * power / factorial(k - j);
    m[i] = factorial(i) * rest / std::pow(length, i + 1);
    for (int k = 0; k < n; ++k) hilbert(i, k) = 1.0 / (i + k + 1);
  }
  return m.dot(hilbert.ldlt().solve(m));
}

bool at_rest(const Ends& from, const Ends& to, int n) {
  for (std::size_t j = 1; j < static_cast<std::size_t>(n); ++j)
    if (*from[j] != 0 || *to[j] != 0) return false;
  return true;
}

std::optional<double> least_peak(const Ends& from, const Ends& to, int n, double length) {
  if (!from[0] || !to[0]) return {};
  const double d = *to[0] - *from[0];
  if (n == 1) return std::abs(d) / length;
  if (!all_given(from, 2) || !all_given(to, 2)) return {};
  const KnotInterval interval{length, d, *from[1], *to[1], from[2], to[2]};
  if (n == 2) return least_peak_acceleration(interval);
  if (n == 3) return least_peak_jerk(interval);
  if (!all_given(from, n) || !all_given(to, n) || !at_rest(from, to, n)) return {};
  return std::pow(4.0, n - 1) * factorial(n - 1) * std::abs(d) / std::pow(length, n);  // (3)
}

/// The order of q = +-f^(n), and its factor.
std::optional<std::pair<int, double>> pure(const LinearQuantity& q) {
  const int n = order_of(q);
  if (n < 1 || q.constant != 0) return {};
  for (int k = 0; k < n; ++k)
    if (q.by[static_cast<std::size_t>(k)] != 0) return {};
  return std::pair{n, std::abs(q.by[static_cast<std::size_t>(n)])};
}

/// The power of an inertia alone: force a f'', velocity b f'.
std::optional<double> least_power(const Ends& from, const Ends& to, const PowerOf& power,
                                  double length) {
  const auto force = pure(power.force);
  const auto velocity = pure(power.velocity);
  if (!force || !velocity || force->first != 2 || velocity->first != 1) return {};
  if (!all_given(from, 2) || !all_given(to, 2)) return {};
  const KnotInterval interval{length, *to[0] - *from[0], *from[1], *to[1], {}, {}};
  return force->second * velocity->second * least_peak_power(interval);
}

}  // namespace

std::optional<double> known_bound(const ShapeProblem& problem, const ShapeFigure& figure) {
  const Ends from = derivatives_of(problem.from);
  const Ends to = derivatives_of(problem.to);
  const double length = problem.end - problem.begin;
  if (const auto* f = std::get_if<PeakOf>(&figure))
    if (const auto q = pure(f->quantity))
      if (const auto least = least_peak(from, to, q->first, length)) return q->second * *least;
  if (const auto* f = std::get_if<PowerOf>(&figure)) return least_power(from, to, *f, length);
  if (const auto* f = std::get_if<RmsOf>(&figure))
    if (const auto q = pure(f->quantity))
      if (all_given(from, q->first) && all_given(to, q->first))
        return q->second * std::sqrt(std::max(0.0, least_mean_square(from, to, q->first, length)));
  return {};
}

}  // namespace jounce::optimize_detail
