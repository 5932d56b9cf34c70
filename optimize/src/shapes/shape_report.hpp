// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "optimize/src/program/shape_model.hpp"

/// The value of a finished shape, from its segments alone, by exact extrema, without the rows of a program.
namespace jounce::optimizer {

/// Corridors and ceilings, each with its smallest margin. A corridor may be exceeded by 1e-9 of the size of its
/// quantity, and a ceiling by 1e-9 of itself: a solver leaves as much.
Report checked(const ShapeProblem& problem, const ShapeModel& model,
               const std::vector<Segment>& shape);

/// Lowers the limits in `held` that the shape exceeds in `problem`, by twice the excess. Returns true if it
/// lowered one. It lowers none if one is exceeded by more than 1e-4 of itself.
bool lower_exceeded(const ShapeProblem& problem, const ShapeModel& model,
                    const std::vector<Segment>& shape, ShapeProblem& held);

/// The results for the figures of the problem, then for its ceilings.
std::vector<FigureResult> figure_results(const ShapeProblem& problem, const SplineSpace& space,
                                         const std::vector<Segment>& given,
                                         const std::vector<Segment>& shape);

/// Limits met to 1e-6 ("limit/...") and places where a figure is attained ("objective/..."), each run of pieces
/// once, where it begins.
std::vector<Finding> active(const ShapeProblem& problem, const ShapeModel& model,
                            const std::vector<Segment>& shape);

/// A lower bound for every function with these end conditions, where one is known: for the peak and the rms of
/// one derivative between given ends.
std::optional<double> known_bound(const ShapeProblem& problem, const ShapeFigure& figure);

}  // namespace jounce::optimizer
