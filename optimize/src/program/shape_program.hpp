// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "optimize/src/program/shape_rows.hpp"

namespace jounce::optimizer {

/// The replacement for t and mu in one kind of program.
struct ShapeTask {
  std::vector<std::optional<double>> level;  ///< level of each term; nullopt: an unknown t
  bool terms = true;                         ///< includes the terms and their rows
  bool elastic = false;  ///< constraints may be exceeded by a common v, which is minimized
  bool round = true;     ///< includes ceilings on norms
  std::vector<Form> squares = {};
  bool squares_alone = false;  ///< only for smoothness: not worth much effort
};

/// A t for every term that is a peak, none given.
ShapeTask plain(const ShapeModel& model);

/// A task as a program in the coordinates, the auxiliary variables of the responses, each t, and v.
struct ShapeProgram {
  ConvexProgram convex;
  std::vector<std::optional<std::size_t>> column = {};  ///< column of the t of each term
  std::optional<std::size_t> slack = {};
};

ShapeProgram program_of(const ShapeModel& model, const ShapeRows& rows, const ShapeTask& task);

/// A lower bound of the objective, with the constraints at their true limits; if elastic, of v alone. `sum`: of
/// the figures of the present shape.
double bound_of(const ShapeModel& model, const ShapeRows& rows, const ShapeTask& task,
                ShapeProgram program, const ConvexSolution& found, double sum);

/// Tiny squares that determine every coordinate that the constraints leave open.
std::vector<Form> hint(const SplineSpace& space);

}  // namespace jounce::optimizer
