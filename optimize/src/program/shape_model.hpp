// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "optimize/src/program/shape_constraints.hpp"
#include "optimize/src/tolerances.hpp"

/// A shape problem over fixed knots, as forms in the coordinates of a spline space.
namespace jounce::optimize_detail {

/// A figure to be minimized. `unit`: its value for the given shape.
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
  /// The limit in the program, a little below `at_most`.
  [[nodiscard]] double held() const {
    return (at_most > 0 ? at_most : natural_zero * rows.natural) * (1 - off);
  }
};

/// The forms of a shape problem.
struct ShapeModel {
  /// `given`: a shape over the whole interval. Every figure must have rows. `auxiliary`: true if
  /// responses have auxiliary unknowns. `scale`: an estimate of the weighted sum in units of its
  /// value for the given shape; the solver uses it as its unit.
  ShapeModel(const ShapeProblem& problem, std::vector<double> knots,
             const std::vector<Segment>& given, bool auxiliary = false, double scale = 1);
  ShapeModel(const ShapeModel&) = delete;
  ShapeModel& operator=(const ShapeModel&) = delete;

  SplineSpace space;
  /// == 0: continuity at breaks, ends, values that are kept exactly; of size one
  std::vector<Form> equalities;
  std::vector<bool> fixed;  ///< true for a coordinate that the equalities alone determine
  double scale = 1;         ///< common factor of the units of the terms
  std::vector<Term> terms;  ///< the figures that are minimized
  std::vector<ShapeConstraint> constraints;  ///< corridors, and ceilings of figures by planes
  std::vector<RoundCeiling> round;           ///< ceilings of norms
  std::vector<Form> definitions;  ///< == 0: each defines an auxiliary variable by the coordinates
  /// Greatest value of each auxiliary variable if all ceilings hold.
  std::vector<double> auxiliary_most;

  /// Number of coordinates and auxiliary variables.
  [[nodiscard]] std::size_t unknowns() const { return space.size() + definitions.size(); }
  /// Returns the coordinates, followed by the auxiliary variables.
  [[nodiscard]] std::vector<double> with_auxiliary(const Coordinates& z) const;
  /// Returns the greatest difference of an auxiliary variable between coordinates that differ by
  /// `range`.
  [[nodiscard]] double range_of_auxiliary(std::size_t k, const std::vector<double>& range) const;

  /// Returns the share of the slope of a form that is not fixed; 0: the form cannot change.
  [[nodiscard]] double freedom(const Form& form) const;
};

/// Returns the sum of weight * figure / unit, in the scale of the model.
double weighted_sum(const ShapeModel& model, const std::vector<Segment>& shape);

/// Returns the knots of `pieces` equal pieces, and the knots where corridors begin and end.
std::vector<double> first_knots(const ShapeProblem& problem);

/// Returns the ends of the pieces of a shape.
std::vector<double> knots_of(const ShapeProblem& problem, const std::vector<Segment>& shape);

/// Returns the shape for the start and for comparison: `given`, or the smoothest polynomial through
/// the ends. With m conditions at the end that has more of them, this is the polynomial with the
/// least integral of (f^(m))^2.
std::vector<Segment> given_shape(const ShapeProblem& problem);

/// Sets the values that corridors without width require, exact to the last bit.
void make_exact(const ShapeProblem& problem, std::vector<Segment>& shape);

}  // namespace jounce::optimize_detail
