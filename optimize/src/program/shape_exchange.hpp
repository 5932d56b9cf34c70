// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "optimize/src/program/shape_model.hpp"

/// Solves a ShapeModel with its figures and constraints at every place: an exchange method over convex
/// programs.
namespace jounce::optimize_detail {

/// Result of minimized().
struct ShapeSolution {
  enum class End {
    solved,      ///< no row exceeds its level any more
    infeasible,  ///< proven: no shape satisfies all constraints
    stalled,     ///< ended by rounding, or by the greatest number of rounds
    stopped,     ///< go_on returned false
  };
  End end = End::stalled;  ///< status at the end
  std::string why;         ///< reason, one sentence, for `infeasible` and `stalled`
  Coordinates z;           ///< coordinates of the result
  std::optional<double> bound =
      {};              ///< bound of the weighted sum over these knots, by weak duality
  int rounds = 0;      ///< number of rounds
  int iterations = 0;  ///< iterations of the interior point method
};

/// Called before each round with its number and the weighted sum so far.
using GoOn = std::function<bool(int round, double value)>;

/// Minimizes the weighted sum. If all figures are peaks, many shapes have the least sum. Of those
/// within `slack` (relative) of it, the smoothest one is returned; with slack 0, any of them.
/// `start` belongs to the space of the model.
ShapeSolution minimized(const ShapeModel& model, const Coordinates& start, double precision,
                        double slack, const GoOn& go_on);

}  // namespace jounce::optimize_detail
