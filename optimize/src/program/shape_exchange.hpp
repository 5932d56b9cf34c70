// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "optimize/src/program/shape_model.hpp"

/// Solves a ShapeModel with its figures and constraints at every place: an exchange method over convex
/// programs.
namespace jounce::optimizer {

struct ShapeSolution {
  enum class End {
    solved,      ///< no row exceeds its level any more
    infeasible,  ///< proven: the constraints cannot all be kept
    stalled,     ///< rounding, or the last round is used
    stopped,     ///< go_on returned false
  };
  End end = End::stalled;
  std::string why;  ///< infeasible or stalled, one sentence
  Coordinates z;
  std::optional<double> bound =
      {};  ///< bound of the weighted sum over these knots, by weak duality
  int rounds = 0;
  int iterations = 0;  ///< iterations of the interior point method
};

/// Called before each round with its number and the weighted sum so far.
using GoOn = std::function<bool(int round, double value)>;

/// Minimizes the weighted sum. Peaks alone leave many shapes open: of those within `slack` (relative) of the
/// least sum the function returns the smoothest; 0: any of them. `start` is in the space of the model.
ShapeSolution minimized(const ShapeModel& model, const Coordinates& start, double precision,
                        double slack, const GoOn& go_on);

}  // namespace jounce::optimizer
