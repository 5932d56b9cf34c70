// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "optimize/src/program/shape_rows.hpp"

namespace jounce::optimize_detail {

/// One kind of program: how it replaces t and mu.
struct ShapeTask {
  std::vector<std::optional<double>> level;  ///< level of each term; nullopt: an unknown t
  bool terms = true;                         ///< includes the terms and their rows
  bool elastic = false;   ///< true: constraints may be exceeded by a common v, which is minimized
  double slack_unit = 1;  ///< unit of v, about its size: the program is well scaled
  bool round = true;      ///< includes ceilings on norms
  std::vector<Form> squares = {};
  bool squares_alone = false;  ///< only for smoothness: not worth much effort
};

/// Returns the task with an unknown t for every term that is a peak.
ShapeTask plain(const ShapeModel& model);

/// A task as a program. Its unknowns are the coordinates, the auxiliary variables, each t, and v.
struct ShapeProgram {
  ConvexProgram convex;
  std::vector<std::optional<std::size_t>> column = {};  ///< index of the unknown t of each term
  std::optional<std::size_t> slack = {};                ///< index of the unknown v
};

/// Returns the program of a task.
ShapeProgram program_of(const ShapeModel& model, const ShapeRows& rows, const ShapeTask& task);

/// Returns a lower bound of the objective, with the constraints at their true limits; if elastic,
/// of v alone. `sum`: sum of the figures of the present shape.
double bound_of(const ShapeModel& model, const ShapeRows& rows, const ShapeTask& task,
                ShapeProgram program, const ConvexSolution& found, double sum);

/// Returns very small squares. They determine every coordinate that the constraints leave free.
std::vector<Form> hint(const SplineSpace& space);

}  // namespace jounce::optimize_detail
