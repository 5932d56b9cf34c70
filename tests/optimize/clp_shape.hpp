// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include <coin/ClpSimplex.hpp>
#include <coin/CoinPackedMatrix.hpp>

// The yardstick: Clp's simplex method (EPL; in tests and benches only) on a grid, with nothing of ours.
// Unknowns are the coefficients of f^(order) as a B-spline; what is fixed at the ends are its moments.
namespace jounce::test_optimize {

/// The B-splines of `degree` over `pieces` equal pieces of [0, 1] (knots repeated at the ends) that do
/// not vanish at x, from the first one's index on (Cox and de Boor).
struct Basis {
  std::size_t first = 0;
  std::array<double, 8> value{};
};

inline Basis basis_at(double x, std::size_t pieces, std::size_t degree) {
  const auto n = static_cast<double>(pieces);
  const std::size_t i = std::min(static_cast<std::size_t>(x * n), pieces - 1);
  const auto knot = [&](std::ptrdiff_t k) {  // knot(0) begins piece i
    return std::clamp((static_cast<double>(i) + static_cast<double>(k)) / n, 0.0, 1.0);
  };
  Basis b{i, {1}};
  for (std::size_t d = 1; d <= degree; ++d)
    for (std::size_t k = d + 1; k-- > 0;) {
      const auto from = static_cast<std::ptrdiff_t>(k) - static_cast<std::ptrdiff_t>(d);
      const auto width = static_cast<std::ptrdiff_t>(d);
      double sum = 0;
      if (k > 0) sum += (x - knot(from)) / (knot(from + width) - knot(from)) * b.value[k - 1];
      if (k < d)
        sum +=
            (knot(from + 1 + width) - x) / (knot(from + 1 + width) - knot(from + 1)) * b.value[k];
      b.value[k] = sum;
    }
  return b;
}

/// The least max |f^(order)| of the splines of degree 5 from rest at 0 to rest at 1 (acceleration 0 too)
/// at `density` places a piece.
inline double clp_least_peak(std::size_t pieces, int order, std::size_t density) {
  const std::size_t degree = 5 - static_cast<std::size_t>(order);
  const std::size_t n = pieces + degree;
  const std::size_t grid = pieces * density;
  CoinPackedMatrix rows(false, 0, 0);
  rows.setDimensions(0, static_cast<int>(n + 1));
  std::vector<double> low, high;
  const auto add = [&](const std::vector<double>& dense, double lo, double hi) {
    std::vector<int> index;
    std::vector<double> factor;
    for (std::size_t k = 0; k < dense.size(); ++k)
      if (dense[k] != 0) {
        index.push_back(static_cast<int>(k));
        factor.push_back(dense[k]);
      }
    rows.appendRow(static_cast<int>(index.size()), index.data(), factor.data());
    low.push_back(lo);
    high.push_back(hi);
  };
  for (std::size_t g = 0; g <= grid; ++g)
    for (const double sign : {1.0, -1.0}) {
      const Basis b = basis_at(static_cast<double>(g) / static_cast<double>(grid), pieces, degree);
      std::vector<double> row(n + 1, 0);
      for (std::size_t k = 0; k <= degree; ++k) row[b.first + k] = sign * b.value[k];
      row[n] = -1;
      add(row, -COIN_DBL_MAX, 0);
    }
  // f^(j)(1) = integral of (1 - x)^(order-1-j) / (order-1-j)! f^(order), by Gauss's rule with 3 places.
  for (int j = 0; j < order; ++j) {
    std::vector<double> row(n + 1, 0);
    for (std::size_t i = 0; i < pieces; ++i)
      for (const auto& [s, w] : {std::pair{0.5 - std::sqrt(0.15), 5.0 / 18},
                                 {0.5, 8.0 / 18},
                                 {0.5 + std::sqrt(0.15), 5.0 / 18}}) {
        const double x = (static_cast<double>(i) + s) / static_cast<double>(pieces);
        const Basis b = basis_at(x, pieces, degree);
        const double weight = w / static_cast<double>(pieces) * std::pow(1 - x, order - 1 - j) /
                              std::tgamma(order - j);
        for (std::size_t k = 0; k <= degree; ++k) row[b.first + k] += weight * b.value[k];
      }
    add(row, j == 0 ? 1 : 0, j == 0 ? 1 : 0);
  }
  std::vector<double> lower(n + 1, -COIN_DBL_MAX), upper(n + 1, COIN_DBL_MAX), cost(n + 1, 0);
  cost[n] = 1;
  if (order == 2)  // acceleration is zero at both ends
    for (const std::size_t k : {std::size_t{0}, n - 1}) lower[k] = upper[k] = 0;
  ClpSimplex clp;
  clp.setLogLevel(0);
  clp.loadProblem(rows, lower.data(), upper.data(), cost.data(), low.data(), high.data());
  clp.initialDualSolve();
  return clp.isProvenOptimal() ? clp.objectiveValue() : std::nan("");
}

}  // namespace jounce::test_optimize
