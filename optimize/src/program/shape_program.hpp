// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "optimize/src/program/shape_rows.hpp"

namespace jounce::optimizer {

/// What stands instead of t and mu in one kind of program.
struct ShapeTask {
  std::vector<std::optional<double>> level;  ///< level of terms: given, or a t of its own
  bool terms = true;                         ///< with their rows
  bool elastic = false;                      ///< walls may be broken by a common v, to be minimised
  bool round = true;                         ///< with ceilings that are round
  std::vector<Form> squares = {};
  bool squares_alone = false;  ///< only to be smoother: not worth much trouble
};

/// A t for every term that is a peak, none given.
ShapeTask plain(const ShapeModel& model);

/// A task as a program in the coordinates, the responses' own unknowns, each t, and v.
struct ShapeProgram {
  ConvexProgram convex;
  std::vector<std::optional<std::size_t>> column = {};  ///< column of each term's t
  std::optional<std::size_t> slack = {};
};

ShapeProgram program_of(const ShapeModel& model, const ShapeRows& rows, const ShapeTask& task);

/// What the objective of the program cannot be below, its walls where they really stand; elastic, v alone.
/// `sum`: of the figures of the shape found.
double bound_of(const ShapeModel& model, const ShapeRows& rows, const ShapeTask& task,
                ShapeProgram program, const ConvexSolution& found, double sum);

/// Squares next to nothing, which leave no coordinate open where walls do.
std::vector<Form> hint(const SplineSpace& space);

}  // namespace jounce::optimizer
