#include "jounce/optimize/detail/shape_model.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace jounce::optimizer {
namespace {

constexpr double same_knot = 1e-6;  ///< of a piece

struct Size {
  double unit = 1;
  double offset = 0;
};

/// The largest size that an edge of a corridor asks for, in units of its value; `exact`: of those that
/// are kept exactly.
double size_of_edges(const ShapeProblem& p, double offset, bool exact) {
  double size = 0;
  double per_unit = 1;
  for (int k = 0; k <= std::min(p.degree, 5); ++k) {  // as the units of SplineSpace
    for (const Corridor& c : p.corridors) {
      if (order_of(c.quantity) != k || (exact && !is_exact(c))) continue;
      const double by = std::abs(c.quantity.by[static_cast<std::size_t>(k)]);
      const double zero = c.quantity.constant + c.quantity.by[0] * offset;
      for (const auto& edge : {c.lower, c.upper})
        if (edge)
          for (const double at : {edge->at_from, edge->at_to})
            size = std::max(size, std::abs(at - zero) * per_unit / by);
    }
    per_unit *= (p.end - p.begin) / (k == 0 ? 1.0 : 4.0 * k);
  }
  return size;
}

/// The size of the values: of the given shape and of what must be followed exactly; of a shape that
/// stands still, of all that its corridors ask for.
Size size_of(const ShapeProblem& p, const std::vector<Segment>& given) {
  const double offset = value(given.front(), 0);
  double size = size_of_edges(p, offset, true);
  double per_unit = 1;
  for (int k = 0; k <= std::min(p.degree, 5); ++k) {
    LinearQuantity q = derivative_of_shape(k);
    if (k == 0) q.constant = -offset;
    size = std::max(size, std::abs(peak_of(q, given, p.begin).value) * per_unit);
    per_unit *= (p.end - p.begin) / (k == 0 ? 1.0 : 4.0 * k);
  }
  if (!(size > 1e-12 * std::abs(offset))) size = size_of_edges(p, offset, false);
  return {size > 0 ? size : 1, offset};
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

bool is_within(const SplineSpace& space, const Corridor& c, std::size_t piece) {
  const double near = same_knot * space.length(piece);
  return space.knots()[piece] >= c.from - near && space.knots()[piece + 1] <= c.to + near;
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

int order_in(const ShapeFigure& figure) {
  if (const auto* f = std::get_if<PeakOf>(&figure)) return order_of(f->quantity);
  if (const auto* f = std::get_if<RmsOf>(&figure)) return order_of(f->quantity);
  return 2;  // a torque, mostly
}

/// The highest derivative that is minimised or limited.
int order_in(const ShapeProblem& p) {
  int order = 1;
  for (const WeightedFigure& m : p.minimize) order = std::max(order, order_in(m.figure));
  for (const jounce::Ceiling& c : p.ceilings) order = std::max(order, order_in(c.figure));
  for (const Corridor& c : p.corridors) order = std::max(order, order_of(c.quantity));
  return std::min(order, p.degree);
}

/// Which side of a corridor: sign (q - edge) <= 0.
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
  return scale > 1e-9 * natural ? scale : natural;
}

Wall wall_of(const SplineSpace& space, const Corridor& c, double offset) {
  Wall wall{"limit/" + c.quantity.name, scale_of(space, c, offset)};
  const auto sides = sides_of(c);
  if (c.from == c.to) {
    for (const Flank& side : sides)
      wall.start.push_back(scaled(at_one_place(space, c, side.edge), side.sign));
    wall.beyond = [](const auto&, double) { return std::vector<Form>{}; };
    return wall;
  }
  const bool bends = space.degree() - order_of(c.quantity) >= 2;
  for (std::size_t i = 0; i < space.pieces(); ++i) {
    if (!is_within(space, c, i)) continue;
    for (const Flank& side : sides)
      for (const double s : {0.0, 0.5, 1.0})
        if ((s != 0.5 || bends) && (s != 1 || order_of(c.quantity) == space.degree() ||
                                    i + 1 == space.pieces() || !is_within(space, c, i + 1)))
          wall.start.push_back(scaled(point_form(space, c, side.edge, i, s), side.sign));
  }
  wall.beyond = [&space, c, sides, scale = wall.scale](const std::vector<Segment>& shape,
                                                       double slack) {
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
  return wall;
}

/// q == edge: all derivatives of q - edge vanish where the first piece begins; on the others those
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

Wall wall_of(FigureRows rows, double at_most) {
  Wall wall{"limit/" + rows.name, at_most > 0 ? at_most : rows.natural};
  for (const Form& f : rows.start) wall.start.push_back(minus(f, at_most));
  wall.beyond = [rows = std::move(rows), at_most, scale = wall.scale](
                    const std::vector<Segment>& shape, double slack) {
    std::vector<Form> broken = rows.cuts(shape, at_most + slack * scale);
    for (Form& f : broken) f.constant -= at_most;
    return broken;
  };
  return wall;
}

/// Coordinates that stand alone in an equality, and those that follow from them at the next knot.
std::vector<bool> fixed_by(const SplineSpace& space, const std::vector<Form>& equalities) {
  std::vector<bool> fixed(space.size(), false);
  for (const Form& f : equalities)
    if (f.terms.size() == 1) fixed[f.terms.front().index] = true;
  for (std::size_t i = 0; i < space.pieces(); ++i) {
    bool known = true;
    for (int j = space.degree(); j >= 0; --j) {
      known = known && fixed[space.index(i, j)];
      if (known && j < space.degree()) fixed[space.index(i + 1, j)] = true;
    }
  }
  return fixed;
}

}  // namespace

ShapeModel::ShapeModel(const ShapeProblem& problem, std::vector<double> knots,
                       const std::vector<Segment>& given)
    : space([&] {
        const Size size = size_of(problem, given);
        return SplineSpace(std::move(knots), problem.degree, order_in(problem), size.unit,
                           size.offset);
      }()) {
  equalities = space.joints();
  for (Form& f : space.ends(problem.from, problem.to, problem.periodic))
    equalities.push_back(std::move(f));
  const double offset = value(given.front(), 0);
  for (const Corridor& c : problem.corridors) {
    if (is_exact(c))
      add_exact(space, c, equalities);
    else
      walls.push_back(wall_of(space, c, offset));
  }
  fixed = fixed_by(space, equalities);
  for (const jounce::Ceiling& c : problem.ceilings) {
    FigureRows rows = figure_rows(c.figure, space);
    if (rows.by_squares())
      round.push_back({std::move(rows), c.at_most});
    else
      walls.push_back(wall_of(std::move(rows), c.at_most));
  }
  for (const WeightedFigure& m : problem.minimize) {
    FigureRows rows = figure_rows(m.figure, space);
    const double value = rows.value(given);
    const double unit = value > 1e-9 * rows.natural ? value : rows.natural;
    terms.push_back({std::move(rows), m.weight, unit, order_in(m.figure)});
  }
}

double ShapeModel::freedom(const Form& form) const {
  double all = 0;
  double open = 0;
  for (const Form::Term& t : form.terms) {
    all += std::abs(t.factor);
    if (t.index >= fixed.size() || !fixed[t.index]) open += std::abs(t.factor);
  }
  return all > 0 ? open / all : 0;
}

double edge_at(const Corridor& c, const Edge& edge, double x) {
  if (c.to == c.from) return edge.at_from;
  const double s = std::clamp((x - c.from) / (c.to - c.from), 0.0, 1.0);
  return s == 1 ? edge.at_to : edge.at_from + s * (edge.at_to - edge.at_from);
}

bool is_exact(const Corridor& c) {
  return c.lower && c.upper && c.lower->at_from == c.upper->at_from &&
         c.lower->at_to == c.upper->at_to;
}

std::vector<double> first_knots(const ShapeProblem& p) {
  const double h = (p.end - p.begin) / static_cast<double>(p.pieces);
  std::vector<double> kept{p.begin, p.end};  // these stay where they are
  for (const Corridor& c : p.corridors)
    if (c.from < c.to) kept.insert(kept.end(), {c.from, c.to});
  std::sort(kept.begin(), kept.end());
  std::vector<double> knots;
  for (const double x : kept)
    if (knots.empty() || x - knots.back() > same_knot * h) knots.push_back(x);
  knots.back() = p.end;
  const auto fixed = knots;
  for (std::size_t i = 1; i < p.pieces; ++i) {
    const double x = p.begin + static_cast<double>(i) * h;
    const auto after = std::lower_bound(fixed.begin(), fixed.end(), x);
    const double apart = std::min(*after - x, x - *std::prev(after));
    if (apart > 0.25 * h) knots.push_back(x);
  }
  std::sort(knots.begin(), knots.end());
  return knots;
}

std::vector<Segment> given_shape(const ShapeProblem& p) {
  if (!p.given.empty()) return p.given;
  int conditions = 1;
  double size = 0;
  double power = 1;
  const auto a = derivatives_of(p.from);
  const auto b = derivatives_of(p.to);
  for (std::size_t k = 0; k < a.size(); ++k, power *= p.end - p.begin) {
    if (a[k] || b[k]) conditions = static_cast<int>(k) + 1;
    if (k == 0 && a[0] && b[0]) size = std::abs(*b[0] - *a[0]);
    if (k == 0 && a[0].has_value() != b[0].has_value()) continue;
    if (k > 0)
      size =
          std::max({size, std::abs(a[k].value_or(0)) * power, std::abs(b[k].value_or(0)) * power});
  }
  const double offset = a[0] ? *a[0] : b[0].value_or(0);
  const SplineSpace space({p.begin, p.end}, 2 * conditions - 1, 2 * conditions - 1,
                          size > 0 ? size : 1, offset);
  ConvexProgram program{std::vector<double>(space.size(), 0), {}, {}, space.joints()};
  for (Form& f : space.ends(p.from, p.to, p.periodic)) program.equalities.push_back(std::move(f));
  LinearQuantity bend{.name = "", .by = {}};
  bend.by[static_cast<std::size_t>(conditions)] =
      1 / space.natural(derivative_of_shape(conditions));
  program.squares = space.squares(bend);
  for (Form& f : program.squares) f = scaled(std::move(f), 1 / std::sqrt(p.end - p.begin));
  return space.segments(solve(program, std::vector<double>(space.size(), 0)).x);
}

void make_exact(const ShapeProblem& p, std::vector<Segment>& shape) {
  for (const Corridor& c : p.corridors) {
    const int k = order_of(c.quantity);
    if (!is_exact(c) || c.from == c.to || k > 1) continue;
    LinearQuantity pure{.name = "", .by = {}};
    pure.by[static_cast<std::size_t>(k)] = 1;
    if (c.quantity.by != pure.by || c.quantity.constant != 0) continue;
    double x = p.begin;
    for (Segment& f : shape) {
      const double near = same_knot * f.length;
      const double end = x + f.length;
      if (x >= c.from - near && end <= c.to + near) {
        const double from = edge_at(c, *c.lower, x);
        const double to = edge_at(c, *c.lower, end);
        if (k == 0)
          f = line(f.length, from, to);
        else if (from == to)
          f = line(f.length, f.c[0], f.c[0] + from * f.length);
      }
      x = end;
    }
  }
}

}  // namespace jounce::optimizer
