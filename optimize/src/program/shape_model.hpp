// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "optimize/src/program/shape_constraints.hpp"
#include "optimize/src/tolerances.hpp"

/// A shape problem over fixed knots, as forms in the coordinates of a spline space.
namespace jounce::optimizer {

/// A figure to be minimized, in `unit`: its value for the given shape.
struct Term {
  FigureRows rows;
  double weight = 1;
  double unit = 1;
  int order = 0;  ///< order of its highest derivative
};

/// A figure whose square is limited, by a second-order cone instead of planes.
struct RoundCeiling {
  FigureRows rows;
  double at_most = 0;

  static constexpr double off = 1e-10;  ///< relative rounding of a solver
  /// The limit of the program, a little below `at_most`.
  [[nodiscard]] double held() const {
    return (at_most > 0 ? at_most : natural_zero * rows.natural) * (1 - off);
  }
};

struct ShapeModel {
  /// `given`: a shape over the whole interval. Every figure must have rows. `auxiliary`: responses have unknowns of
  /// their own. `scale`: an estimate of the weighted sum, which is 1 for the given shape. The solver uses it as
  /// unit.
  ShapeModel(const ShapeProblem& problem, std::vector<double> knots,
             const std::vector<Segment>& given, bool auxiliary = false, double scale = 1);
  ShapeModel(const ShapeModel&) = delete;
  ShapeModel& operator=(const ShapeModel&) = delete;

  SplineSpace space;
  std::vector<Form> equalities;  ///< joints, ends, intervals in step: of size one
  std::vector<bool> fixed;       ///< coordinates that the equalities alone determine
  double scale = 1;              ///< common factor of the units of the terms
  std::vector<Term> terms;
  std::vector<ShapeConstraint> constraints;
  std::vector<RoundCeiling> round;
  std::vector<Form> definitions;       ///< == 0: define each auxiliary variable by the coordinates
  std::vector<double> auxiliary_most;  ///< greatest value of each where all ceilings are kept

  /// Coordinates and unknowns of responses.
  [[nodiscard]] std::size_t unknowns() const { return space.size() + definitions.size(); }
  /// Coordinates followed by the unknowns of the responses.
  [[nodiscard]] std::vector<double> with_auxiliary(const Coordinates& z) const;
  /// The greatest difference of an unknown of a response where coordinates differ by `range`.
  [[nodiscard]] double range_of_auxiliary(std::size_t k, const std::vector<double>& range) const;

  /// The share of the slope of a form that is not fixed; 0: nothing changes it.
  [[nodiscard]] double freedom(const Form& form) const;
};

/// sum of weight * figure / unit: in the model's scale.
double weighted_sum(const ShapeModel& model, const std::vector<Segment>& shape);

/// `pieces` equal pieces, with knots where corridors begin and end.
std::vector<double> first_knots(const ShapeProblem& problem);

/// The ends of the pieces of a shape.
std::vector<double> knots_of(const ShapeProblem& problem, const std::vector<Segment>& shape);

/// The shape for the start and for comparison: `given`, or the smoothest polynomial through the ends. With m
/// conditions at the end that has more of them, that is the polynomial with the least integral of (f^(m))^2.
std::vector<Segment> given_shape(const ShapeProblem& problem);

/// The segments, with intervals in step exact to the last bit.
void make_exact(const ShapeProblem& problem, std::vector<Segment>& shape);

}  // namespace jounce::optimizer
