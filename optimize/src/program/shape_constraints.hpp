// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "optimize/src/figures/figure_rows.hpp"

namespace jounce::optimize_detail {

/// Distance that is kept from a constraint that something free changes, in units of its scale. It
/// covers the rounding of the solver.
constexpr double margin = 1e-9;

/// A constraint at every place of a range: a corridor, or the ceiling of a figure.
struct ShapeConstraint {
  std::string rule;  ///< "limit/geo_velocity"
  double scale = 1;  ///< unit of violations, > 0
  /// Distance that is kept where something free changes it, in units of `scale`.
  double off = margin;
  /// The first forms. Each is <= 0 if the constraint holds.
  std::vector<Form> start = {};
  /// Returns the forms that a shape exceeds by more than slack * scale: on each piece, at the place
  /// of the greatest excess.
  std::function<std::vector<Form>(const std::vector<Segment>& shape, double slack)> beyond = {};
};

/// Returns the constraint for a corridor or a ceiling. `space` must outlive it, and have knots
/// where the corridor begins and ends.
ShapeConstraint constraint_of(const SplineSpace& space, const Corridor& corridor, double offset);
ShapeConstraint constraint_of(FigureRows rows, double at_most);

/// Adds the equalities of a corridor without width.
void add_exact(const SplineSpace& space, const Corridor& corridor, std::vector<Form>& equalities);

/// Returns the value of an edge at x.
double edge_at(const Corridor& corridor, const Edge& edge, double x);

/// True if the corridor has no width: its quantity is kept exactly.
bool is_exact(const Corridor& corridor);

}  // namespace jounce::optimize_detail
