// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "optimize/src/program/shape_model.hpp"

/// Solves a ShapeModel, its figures and walls at every place: an exchange method over convex programs.
namespace jounce::optimizer {

struct ShapeSolution {
  enum class End {
    solved,      ///< nothing exceeds its level any more
    infeasible,  ///< proven: the walls cannot all be kept
    stalled,     ///< rounding, or no round left
    stopped,     ///< go_on said so
  };
  End end = End::stalled;
  std::string why;  ///< infeasible or stalled, one sentence
  Coordinates z;
  std::optional<double> bound =
      {};  ///< bound of the weighted sum over these knots, by weak duality
  int rounds = 0;
  int iterations = 0;  ///< iterations of the interior point method
};

/// Before each round, with its number and the weighted sum so far.
using GoOn = std::function<bool(int round, double value)>;

/// Minimises the weighted sum. Peaks alone leave much open: of all shapes within `licence` (relative)
/// of the least sum, then the smoothest; 0: whichever was found. `start` is of the model's space.
ShapeSolution minimised(const ShapeModel& model, const Coordinates& start, double precision,
                        double licence, const GoOn& go_on);

}  // namespace jounce::optimizer
