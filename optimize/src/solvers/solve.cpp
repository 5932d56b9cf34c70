// SPDX-License-Identifier: Apache-2.0
#include "optimize/src/solvers/solve.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "optimize/src/solvers/local_solver.hpp"
#include "optimize/src/solvers/whitening.hpp"

namespace jounce::optimize_detail {
namespace {

/// The rows of the program, then both bounds of every variable, at x = (y, t).
struct Constraints {
  const Program& program;
  const Whitening& whitening;

  [[nodiscard]] std::size_t count() const {
    return program.rows.size() + 2 * program.space.variables.size();
  }

  /// Always writes `gradient`, row by row.
  void operator()(std::span<double> result, std::span<const double> x,
                  std::span<double> gradient) const {
    const std::size_t n = x.size() - 1;
    const Point z = whitening.z(x.first(n));
    const auto knots = separated_knots(program.space, z);
    std::fill(gradient.begin(), gradient.end(), 0.0);
    for (std::size_t i = 0; i < result.size(); ++i) {
      const auto by_z = gradient.subspan(i * x.size(), n);
      if (i < program.rows.size()) {
        const Row& row = program.rows[i];
        result[i] = evaluate(program, row, knots, by_z) - (row.relaxed ? x.back() : 0);
        gradient[i * x.size() + n] = row.relaxed ? -1 : 0;
      } else {
        result[i] = bound(i - program.rows.size(), z, by_z);
      }
      whitening.turn(by_z);
    }
  }

  [[nodiscard]] double bound(std::size_t i, const Point& z, std::span<double> by_z) const {
    const Variable& v = program.space.variables[i / 2];
    const double sign = i % 2 == 0 ? 1 : -1;
    const double width = (v.upper - v.lower) / v.scale;
    const double limit = ((i % 2 == 0 ? v.upper : v.lower) - v.given) / v.scale;
    by_z[i / 2] = sign / width;
    return sign * (z[i / 2] - limit) / width;
  }
};

/// Constraints replaced by their tangents at x0.
struct Tangents {
  Tangents(const Constraints& constraints, std::vector<double> at)
      : x0(std::move(at)), value(constraints.count()), slope(value.size() * x0.size()) {
    constraints(value, x0, slope);
  }
  void operator()(std::span<double> result, std::span<const double> x,
                  std::span<double> gradient) const {
    for (std::size_t i = 0; i < result.size(); ++i) {
      result[i] = value[i];
      for (std::size_t k = 0; k < x.size(); ++k)
        result[i] += slope[i * x.size() + k] * (x[k] - x0[k]);
    }
    std::copy(slope.begin(), slope.end(), gradient.begin());
  }
  std::vector<double> x0;
  std::vector<double> value;
  std::vector<double> slope;
};

/// SLSQP from (0, t) with |y| <= radius. Rows are scaled to 1. A row may be exceeded by less than the margin
/// that the caller keeps. NaN stops the run: NLopt would treat it as a constraint that holds.
template <class Function>
Solved run(const Program& program, const Whitening& whitening, const Function& function, double t,
           double radius, int max_evaluations, const std::function<bool()>& go_on) {
  const std::size_t n = program.space.variables.size();
  LocalProblem local{.rows = program.rows.size() + 2 * n,
                     .row_tolerance = 1e-11,
                     .lower = std::vector<double>(n + 1, -radius),
                     .upper = std::vector<double>(n + 1, radius),
                     .x_relative = 1e-13,
                     .max_evaluations = max_evaluations};
  local.lower.back() = program.least_t;
  local.upper.back() = std::numeric_limits<double>::infinity();
  local.objective = [](std::span<const double> x, std::span<double> gradient) {
    std::fill(gradient.begin(), gradient.end(), 0.0);
    if (!gradient.empty()) gradient.back() = 1;
    return x.back();
  };
  int evaluations = 0;
  bool finite = true;
  std::vector<double> slope(local.rows * (n + 1));
  local.constraints = [&](std::span<const double> x, std::span<double> rows,
                          std::span<double> gradient) {
    ++evaluations;
    function(rows, x, gradient.empty() ? std::span(slope) : gradient);
    for (const double value : rows) finite = finite && std::isfinite(value);
    if (!finite || !go_on()) throw StopSolver{};
  };
  std::vector<double> x(n, 0.0);
  x.push_back(std::max(t, program.least_t));
  x = run_local_solver(local, std::move(x));
  for (const double value : x) finite = finite && std::isfinite(value);
  const double reached = x.back();
  x.pop_back();
  return {clamped(program.space, whitening.z(x)), reached, evaluations, finite};
}

}  // namespace

Solved solve(const Program& program, const Point& z, double t, int max_evaluations,
             const std::function<bool()>& go_on) {
  const Whitening whitening(program, z);
  return run(program, whitening, Constraints{program, whitening}, t,
             std::numeric_limits<double>::infinity(), max_evaluations, go_on);
}

Solved linear_step(const Program& program, const Point& z, double t, double radius) {
  const Whitening whitening(program, z);
  std::vector<double> x(z.size(), 0.0);
  x.push_back(t);
  const Tangents tangents(Constraints{program, whitening}, std::move(x));
  Solved solved = run(program, whitening, tangents, t, radius, 500, [] { return true; });
  solved.evaluations = 1;
  return solved;
}

}  // namespace jounce::optimize_detail
