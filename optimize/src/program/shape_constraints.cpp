// SPDX-License-Identifier: Apache-2.0
#include "optimize/src/program/shape_constraints.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "optimize/src/tolerances.hpp"

namespace jounce::optimize_detail {
namespace {

constexpr double most_off = 1e-2;
constexpr double planes_off =
    1e-8;  ///< relative distance from the ceiling of a figure: planes 1e-7 apart count as one

bool is_within(const SplineSpace& space, const Corridor& c, std::size_t piece) {
  const double near = same_knot * space.length(piece);
  return space.knots()[piece] >= c.from - near && space.knots()[piece + 1] <= c.to + near;
}

Form minus(Form form, double level) {
  form.constant -= level;
  return form;
}

Form of_size_one(Form form) {
  double largest = 0;
  for (const Form::Term& t : form.terms) largest = std::max(largest, std::abs(t.factor));
  return largest > 0 ? scaled(std::move(form), 1 / largest) : form;
}

/// q(f) - edge on a piece.
Segment above(const Corridor& c, const Edge& edge, const Segment& f, double x) {
  Segment g = quantity_of(c.quantity, f);
  g.degree = std::max(g.degree, 1);
  g.c[0] -= edge_at(c, edge, x);
  g.c[1] -= edge_at(c, edge, x + f.length) - edge_at(c, edge, x);
  return g;
}

Form point_form(const SplineSpace& space, const Corridor& c, const Edge& edge, std::size_t piece,
                double s) {
  const double x = space.knots()[piece] + s * space.length(piece);
  return minus(space.at(c.quantity, piece, s), edge_at(c, edge, x));
}

Form at_one_place(const SplineSpace& space, const Corridor& c, const Edge& edge) {
  const std::size_t i = space.piece_at(c.from);
  const double s = std::clamp((c.from - space.knots()[i]) / space.length(i), 0.0, 1.0);
  return minus(space.at(c.quantity, i, s), edge.at_from);
}

/// One side of a corridor: sign (q - edge) <= 0.
struct Flank {
  double sign = 1;
  Edge edge;
};

std::vector<Flank> sides_of(const Corridor& c) {
  std::vector<Flank> sides;
  if (c.upper) sides.push_back({1, *c.upper});
  if (c.lower) sides.push_back({-1, *c.lower});
  return sides;
}

double scale_of(const SplineSpace& space, const Corridor& c, double offset) {
  const double zero = c.quantity.constant + c.quantity.by[0] * offset;
  double scale = 0;
  for (const Flank& side : sides_of(c))
    scale = std::max({scale, std::abs(side.edge.at_from - zero), std::abs(side.edge.at_to - zero)});
  const double natural = space.natural(c.quantity);
  return scale > natural_zero * natural ? scale : natural;
}

}  // namespace

double edge_at(const Corridor& c, const Edge& edge, double x) {
  if (c.to == c.from) return edge.at_from;
  const double s = std::clamp((x - c.from) / (c.to - c.from), 0.0, 1.0);
  return s == 1 ? edge.at_to : edge.at_from + s * (edge.at_to - edge.at_from);
}

bool is_exact(const Corridor& c) {
  return c.lower && c.upper && c.lower->at_from == c.upper->at_from &&
         c.lower->at_to == c.upper->at_to;
}

ShapeConstraint constraint_of(const SplineSpace& space, const Corridor& c, double offset) {
  ShapeConstraint constraint{"limit/" + c.quantity.name, scale_of(space, c, offset)};
  const auto sides = sides_of(c);
  if (c.from == c.to) {
    for (const Flank& side : sides)
      constraint.start.push_back(scaled(at_one_place(space, c, side.edge), side.sign));
    constraint.beyond = [](const auto&, double) { return std::vector<Form>{}; };
    return constraint;
  }
  const bool bends = space.degree() - order_of(c.quantity) >= 2;
  for (std::size_t i = 0; i < space.pieces(); ++i) {
    if (!is_within(space, c, i)) continue;
    for (const Flank& side : sides)
      for (const double s : {0.0, 0.5, 1.0})
        if ((s != 0.5 || bends) && (s != 1 || order_of(c.quantity) == space.degree() ||
                                    i + 1 == space.pieces() || !is_within(space, c, i + 1)))
          constraint.start.push_back(scaled(point_form(space, c, side.edge, i, s), side.sign));
  }
  constraint.beyond = [&space, c, sides, scale = constraint.scale](
                          const std::vector<Segment>& shape, double slack) {
    std::vector<Form> broken;
    for (std::size_t i = 0; i < shape.size(); ++i) {
      if (!is_within(space, c, i)) continue;
      const double x = space.knots()[i];
      for (const Flank& side : sides) {
        const Segment room = above(c, side.edge, shape[i], x);
        const Range range = segment_range(room, 0, room.length, 0);
        const Extremum& e = side.sign > 0 ? range.max : range.min;
        const double excess = side.sign * e.value - slack * scale;
        if (excess <= 0) continue;
        const double at = std::clamp(e.where / room.length, 0.0, 1.0);
        for (const double s : places_around(room, at, excess))
          broken.push_back(scaled(point_form(space, c, side.edge, i, s), side.sign));
      }
    }
    return broken;
  };
  return constraint;
}

/// q == edge: all derivatives of q - edge vanish where the first piece begins, and on the other pieces those
/// that may step there.
void add_exact(const SplineSpace& space, const Corridor& c, std::vector<Form>& equalities) {
  if (c.from == c.to) {
    equalities.push_back(of_size_one(at_one_place(space, c, *c.lower)));
    return;
  }
  int lowest = 0;
  while (c.quantity.by[static_cast<std::size_t>(lowest)] == 0) ++lowest;
  bool first = true;
  for (std::size_t i = 0; i < space.pieces(); ++i) {
    if (!is_within(space, c, i)) continue;
    const double x = space.knots()[i];
    const double slope =
        (edge_at(c, *c.lower, x + space.length(i)) - edge_at(c, *c.lower, x)) / space.length(i);
    for (int j = first ? 0 : space.degree() - order_of(c.quantity); j <= space.degree() - lowest;
         ++j) {
      const double target = j == 0 ? edge_at(c, *c.lower, x) : j == 1 ? slope : 0;
      equalities.push_back(of_size_one(minus(space.derivative_at(c.quantity, i, j), target)));
    }
    first = false;
  }
}

ShapeConstraint constraint_of(FigureRows rows, double at_most) {
  ShapeConstraint constraint{"limit/" + rows.name, at_most > 0 ? at_most : rows.natural};
  constraint.off = planes_off;
  if (rows.accuracy > 0)
    constraint.off =
        std::clamp(rows.accuracy * rows.natural / constraint.scale, planes_off, most_off);
  for (const Form& f : rows.start) constraint.start.push_back(minus(f, at_most));
  constraint.beyond = [rows = std::move(rows), at_most, scale = constraint.scale](
                          const std::vector<Segment>& shape, double slack) {
    std::vector<Form> broken = rows.cuts(shape, at_most + slack * scale);
    for (Form& f : broken) f.constant -= at_most;
    return broken;
  };
  return constraint;
}

}  // namespace jounce::optimize_detail
