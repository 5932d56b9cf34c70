// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace jounce::optimize_detail {

/// Thrown by a function of a LocalProblem to end the run at the best point so far.
struct StopSolver {};

/// A smooth problem: minimize objective(x) subject to constraints(x) <= 0 and lower <= x <= upper.
/// If the method does not need a gradient, the functions get an empty one. They may throw.
struct LocalProblem {
  enum class Method {
    slsqp,   ///< sequential quadratic programming, with gradients
    cobyla,  ///< linear approximations, without derivatives
  };

  Method method = Method::slsqp;
  /// Returns the objective and writes its gradient.
  std::function<double(std::span<const double> x, std::span<double> gradient)> objective = {};
  /// Writes the constraints and their gradients, row by row.
  std::function<void(std::span<const double> x, std::span<double> rows, std::span<double> gradient)>
      constraints = {};
  std::size_t rows = 0;            ///< number of constraints
  double row_tolerance = 0;        ///< excess of a constraint that is permitted
  std::vector<double> lower = {};  ///< one for each variable; empty: none
  std::vector<double> upper = {};  ///< one for each variable; empty: none
  double initial_step = 0;         ///< size of the first step, > 0 (cobyla)
  double x_relative = 0;           ///< if > 0: ends when a step changes x by less than this share
  double x_absolute = 0;           ///< if > 0: ends when a step changes x by less than this
  double objective_relative =
      0;                    ///< > 0: ends where a step changes the objective by less, relative
  int max_evaluations = 0;  ///< greatest number of evaluations, > 0
};

/// Runs the method from x and returns the point where it ended. The caller must evaluate that
/// point: the status of NLopt is not returned, because NLopt reports success at infeasible points
/// and failure at good ones. Rethrows an exception of the problem's functions. This is the only
/// function of Jounce that calls NLopt.
std::vector<double> run_local_solver(const LocalProblem& problem, std::vector<double> x);

}  // namespace jounce::optimize_detail
