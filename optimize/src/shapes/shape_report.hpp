// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "optimize/src/program/shape_model.hpp"

/// The evaluation of a finished shape from its segments alone, by exact extrema, without the rows
/// of a program.
namespace jounce::optimize_detail {

/// Returns the findings of corridors and ceilings, each with its smallest margin. A corridor may be
/// exceeded by 1e-9 of the size of its quantity, and a ceiling by 1e-9 of its value, which covers
/// the rounding of a solver.
Report checked(const ShapeProblem& problem, const ShapeModel& model,
               const std::vector<Segment>& shape);

/// Lowers the limits in `held` that the shape exceeds in `problem`, by twice the excess. Returns
/// true if it has lowered any. If a limit is exceeded by more than 1e-4 of its value, it lowers
/// none.
bool lower_exceeded(const ShapeProblem& problem, const ShapeModel& model,
                    const std::vector<Segment>& shape, ShapeProblem& held);

/// Returns the results for the figures of the problem, then for its ceilings.
std::vector<FigureResult> figure_results(const ShapeProblem& problem, const SplineSpace& space,
                                         const std::vector<Segment>& given,
                                         const std::vector<Segment>& shape);

/// Returns the limits that are reached to 1e-6 ("limit/...") and the places where a figure is
/// attained ("objective/..."), one for each run of pieces, at its beginning.
std::vector<Finding> active(const ShapeProblem& problem, const ShapeModel& model,
                            const std::vector<Segment>& shape);

/// Returns a lower bound for every function with these end conditions; nullopt if none is known. It
/// is known for the peak and the rms of one derivative between given ends.
std::optional<double> known_bound(const ShapeProblem& problem, const ShapeFigure& figure);

}  // namespace jounce::optimize_detail
