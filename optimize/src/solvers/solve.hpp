// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <vector>

#include "optimize/src/solvers/program.hpp"

namespace jounce::optimize_detail {

/// Result of solve().
struct Solved {
  Point z;
  double t = 0;
  int evaluations = 0;
  bool finite = true;  ///< false if a constraint became NaN or infinite
};

/// Returns a local solution by SLSQP, or the best point that it has reached (see
/// run_local_solver()). Exceptions of the evaluation are passed on. `go_on` is called at each
/// evaluation; if it returns false, the run ends.
Solved solve(const Program& program, const Point& z, double t, int max_evaluations,
             const std::function<bool()>& go_on);

/// Solves the program linearized at (z, t), within a box of the given radius in whitened
/// coordinates (1: about the distance at which the rows change by their own size). The t of the
/// result is the predicted value. The evaluation counts as one.
Solved linear_step(const Program& program, const Point& z, double t, double radius);

}  // namespace jounce::optimize_detail
