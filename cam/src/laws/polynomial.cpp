// SPDX-License-Identifier: Apache-2.0
#include "cam/src/laws/polynomial.hpp"

#include <array>
#include <cmath>

#include "jounce/cam/detail/pivoted_qr.hpp"
#include "jounce/profiles/error.hpp"

// Let t = 2 u / L - 1 in [-1, 1] and T_n the Chebyshev polynomials: f = sum of b_n T_n(t) and
//
//     (1)  T_0 = 1, T_1 = t, T_(n+1) = 2 t T_n - T_(n-1)
//     (2)  T_(n+1)^(k) = 2 t T_n^(k) + 2 k T_n^(k-1) - T_(n-1)^(k)
//
// A condition of order k is a row: sum of b_n T_n^(k)(t) = value (L / 2)^k. Rows are divided by
// their largest entry, so that the rank shows contradictions and does not depend on units.

namespace jounce {
namespace {

constexpr std::size_t capacity = Segment::max_degree + 1;
using ChebyshevRow = std::array<double, capacity>;

/// T_n^(k)(t) for all n: (1) and (2).
ChebyshevRow chebyshev(double t, int order) {
  std::array<ChebyshevRow, 4> d{};
  d[0][0] = 1;
  d[0][1] = t;
  d[1][1] = 1;
  for (std::size_t n = 1; n + 1 < capacity; ++n)
    for (std::size_t k = 0; k < 4; ++k)
      d[k][n + 1] =
          2 * t * d[k][n] - d[k][n - 1] + (k > 0 ? 2 * static_cast<double>(k) * d[k - 1][n] : 0);
  return d[static_cast<std::size_t>(order)];
}

void require_valid(double length, std::span<const Condition> conditions) {
  require_positive("length", length);
  if (conditions.empty() || conditions.size() > capacity)
    throw InputError(
        "conditions", static_cast<double>(conditions.size()),
        "must be 1 to 12 (degree 11): position, velocity and acceleration at both ends are 6");
  for (const Condition& c : conditions) {
    require_finite("at", c.at);
    require_finite("value", c.value);
    if (c.at < 0 || c.at > length)
      throw InputError("at", c.at, "must lie in the segment, 0 to " + number(length));
    if (c.order < 0 || c.order > 3) throw InputError("order", c.order, "must be 0 to 3");
  }
}

/// Coefficients by powers of s = (t + 1) / 2.
Segment in_powers(double length, const Eigen::VectorXd& b) {
  // T_n(2 s - 1) has integer coefficients; the recurrence (1) in s is exact.
  std::array<ChebyshevRow, capacity> power{};
  power[0][0] = 1;
  power[1][0] = -1;
  power[1][1] = 2;
  for (std::size_t n = 1; n + 1 < capacity; ++n)
    for (std::size_t i = 0; i < capacity; ++i)
      power[n + 1][i] = (i > 0 ? 4 * power[n][i - 1] : 0) - 2 * power[n][i] - power[n - 1][i];
  Segment f;
  f.length = length;
  f.degree = static_cast<int>(b.size()) - 1;
  for (Eigen::Index n = 0; n < b.size(); ++n)
    for (std::size_t i = 0; i < capacity; ++i)
      f.c[i] += b[n] * power[static_cast<std::size_t>(n)][i];
  return f;
}

}  // namespace

Segment polynomial(double length, std::span<const Condition> conditions) {
  require_valid(length, conditions);
  const auto size = static_cast<Eigen::Index>(conditions.size());
  Eigen::MatrixXd rows(size, size);
  Eigen::VectorXd values(size);
  for (Eigen::Index i = 0; i < size; ++i) {
    const Condition& c = conditions[static_cast<std::size_t>(i)];
    const ChebyshevRow row = chebyshev(2 * (c.at / length) - 1, c.order);
    const Eigen::VectorXd full = Eigen::Map<const Eigen::VectorXd>(row.data(), size);
    const double largest = full.cwiseAbs().maxCoeff();
    const double scale = largest > 0 ? largest : 1;
    rows.row(i) = full.transpose() / scale;
    values[i] = c.value * std::pow(length / 2, c.order) / scale;
  }
  const cam_detail::PivotedQr solver(rows);
  if (solver.rank() < size)
    throw InputError("conditions", static_cast<double>(conditions.size()),
                     "contradict each other, or do not determine the polynomial: give each "
                     "derivative at most once a place, and at least one position");
  Eigen::VectorXd b = solver.solve(values);
  b += solver.solve(values - rows * b);  // one step of refinement
  return in_powers(length, b);
}

}  // namespace jounce
