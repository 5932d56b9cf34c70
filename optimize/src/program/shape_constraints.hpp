// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "optimize/src/figures/figure_rows.hpp"

namespace jounce::optimizer {

/// The distance kept from a constraint where something free changes it, in units of its scale: the solver
/// leaves this much rounding.
constexpr double margin = 1e-9;

/// A constraint at every place of a window: a corridor, or the ceiling of a figure.
struct ShapeConstraint {
  std::string rule;     ///< "limit/geo_velocity"
  double scale = 1;     ///< unit of violations, > 0
  double off = margin;  ///< distance kept where something free changes it, in units of `scale`
  /// Forms that are <= 0 where the constraint holds: the first ones.
  std::vector<Form> start = {};
  /// The forms that a shape exceeds by more than slack * scale: on each piece where it exceeds them most.
  std::function<std::vector<Form>(const std::vector<Segment>& shape, double slack)> beyond = {};
};

/// `space` must outlive the constraint and have knots where the corridor begins and ends.
ShapeConstraint constraint_of(const SplineSpace& space, const Corridor& corridor, double offset);
ShapeConstraint constraint_of(FigureRows rows, double at_most);

/// A corridor without width, as equalities.
void add_exact(const SplineSpace& space, const Corridor& corridor, std::vector<Form>& equalities);

/// The value of an edge at x.
double edge_at(const Corridor& corridor, const Edge& edge, double x);

/// True if the corridor has no width: its quantity is kept exactly.
bool is_exact(const Corridor& corridor);

}  // namespace jounce::optimizer
