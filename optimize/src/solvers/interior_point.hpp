// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

namespace jounce::optimize_detail {

/// An affine function of a few unknowns: constant + sum of factor * x[index].
struct Form {
  struct Term {
    std::size_t index = 0;
    double factor = 0;
  };
  double constant = 0;
  std::vector<Term> terms;

  /// Returns its value at x.
  [[nodiscard]] double at(const std::vector<double>& x) const;
};

/// Returns factor * f.
Form scaled(Form f, double factor);

/// A round constraint: the root of the sum of forms(x)^2 is at most `most` > 0.
struct RoundConstraint {
  double most = 1;
  std::vector<Form> forms = {};
};

/// A convex program: minimize slope . x + sum of squares[i](x)^2 subject to constraints[k](x) <= 0,
/// equalities[k](x) = 0, and round constraints (second-order cones). Unknowns and forms should be
/// of about size one. Squares, constraints and equalities together must determine x. If there are
/// equalities, the undetermined part of x stays near its start.
struct ConvexProgram {
  std::vector<double> slope;
  std::vector<Form> squares;
  std::vector<Form> constraints;
  std::vector<Form> equalities = {};
  std::vector<RoundConstraint> round = {};
};

/// Result of solve().
struct ConvexSolution {
  std::vector<double> x;
  std::vector<double> multipliers;  ///< >= 0; one for each constraint
  /// One for each form of each round constraint. The multiplier of `most` is the root of the sum of
  /// their squares.
  std::vector<std::vector<double>> round_multipliers = {};
  std::vector<double> equal_multipliers = {};  ///< one for each equality
  int iterations = 0;                          ///< number of iterations
  double residual = 0;  ///< greatest complementarity or residual of the conditions
};

/// Options of solve().
struct SolveOptions {
  /// True: if rounding stops a run, it starts again with a slower, more stable factorization, then
  /// from a start farther inside the cones.
  bool thorough = true;
  double precision = 1e-11;  ///< residuals and complementarity at which the method ends
  std::function<bool()> go_on =
      nullptr;  ///< called before each iteration; false: ends with the best so far
};

/// Solves with Mehrotra's predictor-corrector method from `start`, which need not be feasible, and
/// with the scaling of Nesterov and Todd for round constraints. The matrices are sparse. Ends when
/// residuals and complementarity are below `precision` or no longer fall.
ConvexSolution solve(const ConvexProgram& program, const std::vector<double>& start,
                     const SolveOptions& options = {});

}  // namespace jounce::optimize_detail
