#pragma once

#include <functional>
#include <string>
#include <vector>

#include "jounce/optimize/detail/figure_rows.hpp"

/// A shape problem over fixed knots, as forms in the coordinates of a spline space.
namespace jounce::optimizer {

/// What must be kept everywhere in a window: a corridor, or a figure's ceiling.
struct Wall {
  std::string rule;  ///< "limit/geo_velocity"
  double scale = 1;  ///< what violations are measured in, > 0
  /// Each <= 0 where the wall is kept; to begin with.
  std::vector<Form> start = {};
  /// Those that a shape breaks by more than slack * scale: where it does so most, on each piece.
  std::function<std::vector<Form>(const std::vector<Segment>& shape, double slack)> beyond = {};
};

/// A figure to be minimised, counted in `unit`: its value for the given shape.
struct Term {
  FigureRows rows;
  double weight = 1;
  double unit = 1;
  int order = 0;  ///< of the highest derivative in it
};

/// A figure whose square is limited: kept by its multiplier, not by planes.
struct RoundCeiling {
  FigureRows rows;
  double at_most = 0;
};

struct ShapeModel {
  /// `given`: a shape over the whole interval. Every figure must have rows.
  ShapeModel(const ShapeProblem& problem, std::vector<double> knots,
             const std::vector<Segment>& given);
  ShapeModel(const ShapeModel&) = delete;
  ShapeModel& operator=(const ShapeModel&) = delete;

  SplineSpace space;
  std::vector<Form> equalities;  ///< joints, ends, stretches in step: of size one
  std::vector<bool> fixed;       ///< coordinates that these alone determine
  std::vector<Term> terms;
  std::vector<Wall> walls;
  std::vector<RoundCeiling> round;

  /// The share of a form's slope that is not fixed: 0 where nothing changes it.
  [[nodiscard]] double freedom(const Form& form) const;
};

/// The value of an edge at x.
double edge_at(const Corridor& corridor, const Edge& edge, double x);

/// Whether the corridor leaves no room: what it holds is kept exactly.
bool is_exact(const Corridor& corridor);

/// `pieces` equal pieces, with knots where corridors begin and end.
std::vector<double> first_knots(const ShapeProblem& problem);

/// What the problem starts from and compares with: `given`, or the smoothest polynomial through the
/// ends: with m conditions at the harder end, the one with the least integral of (f^(m))^2.
std::vector<Segment> given_shape(const ShapeProblem& problem);

/// The segments with stretches in step as they are demanded, to the bit.
void make_exact(const ShapeProblem& problem, std::vector<Segment>& shape);

}  // namespace jounce::optimizer
