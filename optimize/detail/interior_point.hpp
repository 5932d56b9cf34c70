#pragma once

#include <cstddef>
#include <vector>

namespace jounce::optimizer {

/// constant + sum of factor * x[index]: an affine function of a few unknowns.
struct Form {
  struct Term {
    std::size_t index = 0;
    double factor = 0;
  };
  double constant = 0;
  std::vector<Term> terms;

  [[nodiscard]] double at(const std::vector<double>& x) const;
};

/// factor * f.
Form scaled(Form f, double factor);

/// minimise slope . x + sum of squares[i](x)^2   subject to   constraints[k](x) <= 0.
/// Unknowns and forms of about size one. Together squares and constraints must determine x.
struct ConvexProgram {
  std::vector<double> slope;
  std::vector<Form> squares;
  std::vector<Form> constraints;
};

struct ConvexSolution {
  std::vector<double> x;
  std::vector<double> multipliers;  ///< >= 0, one for each constraint
  int iterations = 0;
};

/// Mehrotra's predictor-corrector method from `start`, which need not be feasible. Sparse; stops when
/// residuals and complementarity are below 1e-11 or no longer fall.
ConvexSolution solve(const ConvexProgram& program, const std::vector<double>& start);

}  // namespace jounce::optimizer
