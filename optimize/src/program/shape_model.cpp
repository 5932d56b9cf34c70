// SPDX-License-Identifier: Apache-2.0
#include "optimize/src/program/shape_model.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "optimize/src/tolerances.hpp"

namespace jounce::optimize_detail {
namespace {

/// Share of the natural size: a smaller limit is a limit of zero.
constexpr double silent_share = 1e-6;

struct Size {
  double unit = 1;
  double offset = 0;
};

/// The largest size of the values that an edge of a corridor requires; `exact`: only of corridors that are kept
/// exactly.
double size_of_edges(const ShapeProblem& p, double offset, bool exact) {
  double size = 0;
  double per_unit = 1;
  for (int k = 0; k <= std::min(p.degree, 5); ++k) {  // in the units of SplineSpace
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

/// The size of the values: that of the given shape and of the corridors that are kept exactly; for a shape that
/// stands still, that of all its corridors.
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
  if (!(size > rounding_tolerance * std::abs(offset))) size = size_of_edges(p, offset, false);
  return {size > 0 ? size : 1, offset};
}

int order_in(const ShapeFigure& figure) {
  if (const auto* f = std::get_if<PeakOf>(&figure)) return order_of(f->quantity);
  if (const auto* f = std::get_if<RmsOf>(&figure)) return order_of(f->quantity);
  return 2;  // a torque, mostly
}

/// The highest derivative that is minimized or limited.
int order_in(const ShapeProblem& p) {
  int order = 1;
  for (const WeightedFigure& m : p.minimize) order = std::max(order, order_in(m.figure));
  for (const jounce::Ceiling& c : p.ceilings) order = std::max(order, order_in(c.figure));
  for (const Corridor& c : p.corridors) order = std::max(order, order_of(c.quantity));
  return std::min(order, p.degree);
}

/// Coordinates that are alone in an equality, and those that follow from them at the next knot.
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

/// A limit close to zero on one mode becomes an equality with zero: planes so close together have no interior.
bool is_silence(const Ceiling& c, double natural) {
  const auto* f = std::get_if<ResidualOf>(&c.figure);
  return f && f->low == f->high && f->damping_low == f->damping_high &&
         c.at_most <= silent_share * natural;
}

}  // namespace

ShapeModel::ShapeModel(const ShapeProblem& problem, std::vector<double> knots,
                       const std::vector<Segment>& given, bool auxiliary, double counted_in)
    : space([&] {
        const Size size = size_of(problem, given);
        return SplineSpace(std::move(knots), problem.degree, order_in(problem), size.unit,
                           size.offset);
      }()),
      scale(counted_in) {
  equalities = space.joints();
  for (Form& f : space.ends(problem.from, problem.to, problem.periodic))
    equalities.push_back(std::move(f));
  const double offset = value(given.front(), 0);
  for (const Corridor& c : problem.corridors) {
    if (is_exact(c))
      add_exact(space, c, equalities);
    else
      constraints.push_back(constraint_of(space, c, offset));
  }
  fixed = fixed_by(space, equalities);
  const auto rows_of = [&](const ShapeFigure& figure, std::optional<double> at_most, bool silent) {
    const Auxiliary from{unknowns(), given, at_most};
    FigureRows rows = figure_rows(figure, space, auxiliary && !silent ? &from : nullptr);
    definitions.insert(definitions.end(), rows.definitions.begin(), rows.definitions.end());
    auxiliary_most.resize(definitions.size(), at_most ? rows.auxiliary_share * *at_most : HUGE_VAL);
    return rows;
  };
  for (const jounce::Ceiling& c : problem.ceilings) {
    const bool silent = is_silence(c, space.natural(derivative_of_shape(0)));
    FigureRows rows = rows_of(c.figure, c.at_most, silent);
    if (silent) {  // real and imaginary part
      equalities.push_back(rows.start[0]);
      equalities.push_back(rows.start[2]);
    } else if (rows.by_squares())
      round.push_back({std::move(rows), c.at_most});
    else
      constraints.push_back(constraint_of(std::move(rows), c.at_most));
  }
  for (const WeightedFigure& m : problem.minimize) {
    FigureRows rows = rows_of(m.figure, {}, false);
    const double value = rows.value(given);
    const double unit =
        std::abs(value) > natural_zero * rows.natural ? std::abs(value) : rows.natural;
    terms.push_back({std::move(rows), m.weight, unit * scale, order_in(m.figure)});
  }
}

std::vector<double> ShapeModel::with_auxiliary(const Coordinates& z) const {
  std::vector<double> x = z;
  for (const Form& f : definitions) {  // the first term is the unknown
    double rest = f.constant;
    for (std::size_t j = 1; j < f.terms.size(); ++j)
      rest += f.terms[j].factor * z[f.terms[j].index];
    x.push_back(-rest / f.terms.front().factor);
  }
  return x;
}

double ShapeModel::range_of_auxiliary(std::size_t k, const std::vector<double>& range) const {
  double sum = 0;
  const auto& by = definitions[k].terms;
  for (std::size_t j = 1; j < by.size(); ++j) sum += std::abs(by[j].factor) * range[by[j].index];
  return sum / std::abs(by.front().factor);
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

double weighted_sum(const ShapeModel& model, const std::vector<Segment>& shape) {
  double sum = 0;
  for (const Term& t : model.terms) sum += t.weight * t.rows.value(shape) / t.unit;
  return sum;
}

namespace {

constexpr double near_point = 0.5;  ///< share of the distance of two knots

/// The points that a shape must pass through, in order.
std::vector<double> points_of(const ShapeProblem& p) {
  std::vector<double> points;
  for (const Corridor& c : p.corridors)
    if (c.from == c.to) points.push_back(c.from);
  std::sort(points.begin(), points.end());
  return points;
}

/// The point that is nearer to x than to the next knot. Otherwise the piece between them is short when the
/// shape is written, and an error e of its rise makes a jerk of 60 e / length^3. Without such a point, x.
double moved_to_point(double x, const std::vector<double>& points, double near) {
  const auto above = std::lower_bound(points.begin(), points.end(), x);
  if (above != points.end() && *above - x <= near) return *above;
  if (above != points.begin() && x - *std::prev(above) <= near) return *std::prev(above);
  return x;
}

}  // namespace

std::vector<double> first_knots(const ShapeProblem& p) {
  const double h = (p.end - p.begin) / static_cast<double>(p.pieces);
  std::vector<double> kept{p.begin, p.end};  // these keep their place
  for (const Corridor& c : p.corridors)
    if (c.from < c.to) kept.insert(kept.end(), {c.from, c.to});
  std::sort(kept.begin(), kept.end());
  std::vector<double> knots;
  for (const double x : kept)
    if (knots.empty() || x - knots.back() > same_knot * h) knots.push_back(x);
  knots.back() = p.end;
  const auto fixed = knots;
  const auto points = points_of(p);
  for (std::size_t i = 1; i < p.pieces; ++i) {
    const double x = moved_to_point(p.begin + static_cast<double>(i) * h, points, near_point * h);
    const auto after = std::lower_bound(fixed.begin(), fixed.end(), x);
    const double apart = std::min(*after - x, x - *std::prev(after));
    if (apart > 0.25 * h) knots.push_back(x);
  }
  std::sort(knots.begin(), knots.end());
  knots.erase(std::unique(knots.begin(), knots.end()), knots.end());  // two may move to one point
  return knots;
}

std::vector<double> knots_of(const ShapeProblem& problem, const std::vector<Segment>& shape) {
  std::vector<double> knots{problem.begin};
  for (const Segment& f : shape) knots.push_back(knots.back() + f.length);
  knots.back() = problem.end;
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

}  // namespace jounce::optimize_detail
