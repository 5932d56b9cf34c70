#pragma once

#include <cstddef>
#include <functional>
#include <span>

#include "jounce/validate/detail/solver.hpp"

namespace jounce::detail {

/// How an objective depends on an Ode and its parameters, for the gradient backwards in time:
///
///     G(p) = integral of g(t, y, p) dt + phi(y(T)),        y' = f(t, y, p)
///
/// The gradient costs one integration backwards, however many parameters there are. None of the
/// functions may allocate.
struct Adjoint {
  Ode ode;  ///< rhs and jacobian; of parameters and events nothing is used
  /// dg/dy, handed over filled with zeros; left out: there is no integral
  std::function<void(double t, const double* y, double* dgdy)> objective = {};
  std::size_t parameters = 0;
  /// adds lambda^T df/dp + dg/dp to out, which has `parameters` numbers and is zero
  std::function<void(double t, const double* y, const double* lambda, double* out)> by_parameter;
};

/// One stretch over which f is smooth, and how finely it is walked through.
struct Stretch {
  double begin = 0;
  double end = 0;
  double longest_step = 0;  ///< 0: not limited
};

struct AdjointOptions {
  SolverOptions solver;          ///< of the state
  double relative = 1e-8;        ///< of lambda and of the gradient
  double absolute_lambda = 0;    ///< of every entry of lambda, > 0
  double absolute_gradient = 0;  ///< of every entry of the gradient, > 0
  int checkpoint_steps = 200;    ///< steps held in memory at a time
};

/// Backwards over one stretch. `start` is the state at its begin; lambda holds dG/dy at the end and
/// is replaced by that at the begin; dG/dp of the stretch is added to `gradient`.
///
/// A whole run with jumps is the stretches between them, last first: y+ = y- + d(p) leaves lambda as
/// it is and adds lambda^T dd/dp; at an objective that looks at one instant, lambda is raised by
/// dphi/dy there.
Integration backward(const Adjoint& adjoint, const AdjointOptions& options, const Stretch& stretch,
                     std::span<const double> start, std::span<double> lambda,
                     std::span<double> gradient);

}  // namespace jounce::detail
