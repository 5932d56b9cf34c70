// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "optimize/src/program/shape_walls.hpp"

/// A shape problem over fixed knots, as forms in the coordinates of a spline space.
namespace jounce::optimizer {

/// A figure to be minimised, counted in `unit`: its value for the given shape.
struct Term {
  FigureRows rows;
  double weight = 1;
  double unit = 1;
  int order = 0;  ///< order of the highest derivative in it
};

/// A figure whose square is limited: kept by a second-order cone, not by planes.
struct RoundCeiling {
  FigureRows rows;
  double at_most = 0;

  static constexpr double off = 1e-10;  ///< relative: what a solver leaves
  /// What it is held to: a little less.
  [[nodiscard]] double held() const {
    return (at_most > 0 ? at_most : 1e-9 * rows.natural) * (1 - off);
  }
};

struct ShapeModel {
  /// `given`: a shape over the whole interval. Every figure must have rows. `lift`: responses have
  /// unknowns of their own. `scale`: about what the weighted sum will be, for given shapes are 1; the solver counts in it.
  ShapeModel(const ShapeProblem& problem, std::vector<double> knots,
             const std::vector<Segment>& given, bool lift = false, double scale = 1);
  ShapeModel(const ShapeModel&) = delete;
  ShapeModel& operator=(const ShapeModel&) = delete;

  SplineSpace space;
  std::vector<Form> equalities;  ///< joints, ends, stretches in step: of size one
  std::vector<bool> fixed;       ///< coordinates that these alone determine
  double scale = 1;              ///< that all units of terms have as a factor
  std::vector<Term> terms;
  std::vector<Wall> walls;
  std::vector<RoundCeiling> round;
  std::vector<Form> own;  ///< == 0: what each unknown of a response's own is by the coordinates
  std::vector<double> own_most;  ///< what each is at most, where all ceilings are kept

  /// Coordinates and unknowns of responses.
  [[nodiscard]] std::size_t unknowns() const { return space.size() + own.size(); }
  /// Coordinates followed by the unknowns of responses that belong to them.
  [[nodiscard]] std::vector<double> with_own(const Coordinates& z) const;
  /// How far an unknown of a response differs at most, where coordinates differ by `range`.
  [[nodiscard]] double range_of_own(std::size_t k, const std::vector<double>& range) const;

  /// The share of a form's slope that is not fixed: 0 where nothing changes it.
  [[nodiscard]] double freedom(const Form& form) const;
};

/// sum of weight * figure / unit: in the model's scale.
double weighted_sum(const ShapeModel& model, const std::vector<Segment>& shape);

/// `pieces` equal pieces, with knots where corridors begin and end.
std::vector<double> first_knots(const ShapeProblem& problem);

/// The ends of the pieces of a shape.
std::vector<double> knots_of(const ShapeProblem& problem, const std::vector<Segment>& shape);

/// What the problem starts from and compares with: `given`, or the smoothest polynomial through the
/// ends: with m conditions at the harder end, the one with the least integral of (f^(m))^2.
std::vector<Segment> given_shape(const ShapeProblem& problem);

/// The segments with stretches in step as they are demanded, to the bit.
void make_exact(const ShapeProblem& problem, std::vector<Segment>& shape);

}  // namespace jounce::optimizer
