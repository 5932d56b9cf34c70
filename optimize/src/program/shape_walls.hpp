// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "optimize/src/figures/figure_rows.hpp"

namespace jounce::optimizer {

/// What walls are kept off, in their scale, where something free can do so: what rounding leaves.
constexpr double margin = 1e-9;

/// What must be kept everywhere in a window: a corridor, or a figure's ceiling.
struct Wall {
  std::string rule;     ///< "limit/geo_velocity"
  double scale = 1;     ///< what violations are measured in, > 0
  double off = margin;  ///< in its scale, what it is kept off where something free can do so
  /// Each <= 0 where the wall is kept; to begin with.
  std::vector<Form> start = {};
  /// Those that a shape breaks by more than slack * scale: where it does so most, on each piece.
  std::function<std::vector<Form>(const std::vector<Segment>& shape, double slack)> beyond = {};
};

/// `space` must outlive the wall and have knots where the corridor begins and ends.
Wall wall_of(const SplineSpace& space, const Corridor& corridor, double offset);
Wall wall_of(FigureRows rows, double at_most);

/// A corridor without room, as equalities.
void add_exact(const SplineSpace& space, const Corridor& corridor, std::vector<Form>& equalities);

/// The value of an edge at x.
double edge_at(const Corridor& corridor, const Edge& edge, double x);

/// True if the corridor leaves no room: what it holds is kept exactly.
bool is_exact(const Corridor& corridor);

}  // namespace jounce::optimizer
