// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "optimize/src/program/shape_model.hpp"

/// What a finished shape is worth: from its segments alone, by exact extrema, never from the rows of a
/// program.
namespace jounce::optimizer {

/// Corridors and ceilings, each with its smallest margin, kept or not. A corridor may be passed by 1e-9 of
/// its quantity's size, a ceiling by 1e-9 of itself, which is what a solver leaves.
Report checked(const ShapeProblem& problem, const ShapeModel& model,
               const std::vector<Segment>& shape);

/// Lowers the limits in `held` that the shape exceeds in `problem`, by twice the excess. Returns true if it
/// lowered one. It lowers none where one is exceeded by more than a solver leaves, 1e-4 of itself.
bool lower_exceeded(const ShapeProblem& problem, const ShapeModel& model,
                    const std::vector<Segment>& shape, ShapeProblem& held);

/// What became of the problem's figures, then of its ceilings.
std::vector<FigureResult> figure_results(const ShapeProblem& problem, const SplineSpace& space,
                                         const std::vector<Segment>& given,
                                         const std::vector<Segment>& shape);

/// Limits met to 1e-6 ("limit/..."), and where each figure takes its value ("objective/..."): each run
/// of pieces once, where it begins.
std::vector<Finding> active(const ShapeProblem& problem, const ShapeModel& model,
                            const std::vector<Segment>& shape);

/// What no function with these end conditions has less of, where that is known: peak and rms of one
/// derivative between given ends.
std::optional<double> known_bound(const ShapeProblem& problem, const ShapeFigure& figure);

}  // namespace jounce::optimizer
