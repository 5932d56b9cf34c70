// SPDX-License-Identifier: Apache-2.0
// From a run of a cam to a shape problem.
#include <algorithm>
#include <array>
#include <cmath>

#include "optimize/src/shapes/cam_run.hpp"

namespace jounce::optimize_detail {
namespace {

LinearQuantity derivative_named(const char* name, std::size_t order) {
  LinearQuantity q{name, {}, 0};
  q.by[order] = 1;
  return q;
}

const std::array<const char*, 4> derivative_names{"slave", "geo_velocity", "geo_acceleration",
                                                  "geo_jerk"};

std::size_t pieces_of(const CamShapeProblem& problem, const CamRunOf& run) {
  std::size_t pieces = 0;
  for (const std::size_t i : run.segments) pieces += shape_of(problem, i).pieces;
  return pieces;
}

double on(const Corridor& c, const Edge& edge, double x) {
  if (c.to == c.from) return edge.at_from;
  return edge.at_from + (edge.at_to - edge.at_from) * ((x - c.from) / (c.to - c.from));
}

/// The part of a corridor of the cam over [low, high], moved by `ahead` and `auxiliary`.
void cut(const Corridor& c, double low, double high, double ahead, double auxiliary,
         std::vector<Corridor>& out) {
  const double from = std::max(c.from, low);
  const double to = std::min(c.to, high);
  if (from > to || (from == to && c.from < c.to)) return;
  const double up = c.quantity.by[0] * auxiliary;
  const auto edge = [&](const std::optional<Edge>& e) -> std::optional<Edge> {
    if (!e) return std::nullopt;
    return Edge{on(c, *e, from) + up, on(c, *e, to) + up};
  };
  out.push_back({c.quantity, from + ahead, to + ahead, edge(c.lower), edge(c.upper)});
}

void cut(const Corridor& c, const CamRunOf& run, std::vector<Corridor>& out) {
  const RunKnot& last = run.knots.back();
  const double begin = run.knots.front().master;
  if (last.ahead == 0) {
    cut(c, begin, last.master, 0, 0, out);
    return;
  }
  cut(c, begin, run.start + run.length, 0, 0, out);
  cut(c, run.start, last.master, last.ahead, last.auxiliary, out);
}

/// The effect of an error of the positions at the points on the k-th derivative of a polynomial through them,
/// over pieces of length h: about c_k error / h^k (hermite.hpp).
double worth(const CamShapeProblem& problem, const CamRunOf& run, double accuracy,
             std::size_t order) {
  constexpr std::array c{1., 4., 30., 250.};
  double greatest = 0;
  for (const RunKnot& knot : run.knots)
    greatest = std::max(greatest, std::abs(knot.slave.value_or(0)) + std::abs(knot.auxiliary));
  const double length = run.knots.back().x() - run.knots.front().x();
  const double pieces = static_cast<double>(pieces_of(problem, run)) * (problem.refine ? 4 : 1);
  return c[order] * accuracy * greatest * std::pow(pieces / length, static_cast<double>(order));
}

void add_limits(const CamShapeProblem& problem, const CamRunOf& run, double accuracy,
                std::vector<Corridor>& all) {
  const Limits& limits = problem.limits;
  const double from = problem.cam.start.master;
  const double to = problem.cam.segments.back().end.master;
  const auto add = [&](std::size_t order, std::optional<double> low, std::optional<double> high) {
    if (!low && !high) return;
    Corridor c{derivative_named(derivative_names[order], order), from, to, {}, {}};
    const double room = order == 0 ? 0 : worth(problem, run, accuracy, order);
    if (low) c.lower = Edge{*low + room, *low + room};
    if (high) c.upper = Edge{*high - room, *high - room};
    cut(c, run, all);
  };
  add(0, limits.position_min, limits.position_max);
  const std::array rates{limits.velocity, limits.acceleration, limits.jerk};
  for (std::size_t k = 0; k < rates.size(); ++k)
    if (rates[k]) add(k + 1, -*rates[k], rates[k]);
}

/// A corridor of a derivative over an interval, narrowed on both sides by the effect of the accuracy of the
/// positions.
Corridor narrowed(Corridor c, const CamShapeProblem& problem, const CamRunOf& run,
                  double accuracy) {
  double room = 0;
  for (std::size_t k = 1; k < derivative_names.size(); ++k)
    room += std::abs(c.quantity.by[k]) * worth(problem, run, accuracy, k);
  if (c.from == c.to) return c;
  if (c.lower && c.upper)
    for (const double width :
         {c.upper->at_from - c.lower->at_from, c.upper->at_to - c.lower->at_to})
      if (width < 4 * room) return c;  // kept exactly, or nearly
  if (c.lower) c.lower = Edge{c.lower->at_from + room, c.lower->at_to + room};
  if (c.upper) c.upper = Edge{c.upper->at_from - room, c.upper->at_to - room};
  return c;
}

void add_monotone(const CamShapeProblem& problem, const CamRunOf& run, std::vector<Corridor>& all) {
  const auto resolved = resolved_knots(problem.cam);
  for (std::size_t r = 0; r < run.segments.size(); ++r) {
    const std::size_t i = run.segments[r];
    if (!shape_of(problem, i).monotone) continue;
    Corridor c{derivative_named("geo_velocity", 1), run.knots[r].x(), run.knots[r + 1].x(), {}, {}};
    (resolved[i + 1].slave > resolved[i].slave ? c.lower : c.upper) = Edge{0, 0};
    all.push_back(c);
  }
}

/// A derivative of a knot inside the run, or a bound at one of its ends.
void add_knot(const RunKnot& knot, bool inside, std::vector<Corridor>& all) {
  const auto add = [&](std::size_t order, const std::optional<double>& fixed,
                       const std::optional<Bound>& bound, double auxiliary) {
    Corridor c{derivative_named(derivative_names[order], order), knot.x(), knot.x(), {}, {}};
    if (fixed && inside) c.lower = c.upper = Edge{*fixed + auxiliary, *fixed + auxiliary};
    if (bound && std::isfinite(bound->lower))
      c.lower = Edge{bound->lower + auxiliary, bound->lower + auxiliary};
    if (bound && std::isfinite(bound->upper))
      c.upper = Edge{bound->upper + auxiliary, bound->upper + auxiliary};
    if (c.lower || c.upper) all.push_back(c);
  };
  add(0, knot.slave, knot.free.slave, knot.auxiliary);
  add(1, knot.geo_velocity, knot.free.geo_velocity, 0);
  add(2, knot.geo_acceleration, knot.free.geo_acceleration, 0);
}

ShapeEnd end_of(const RunKnot& knot) {
  ShapeEnd end{knot.slave, knot.geo_velocity, knot.geo_acceleration, knot.geo_jerk};
  if (end.value) *end.value += knot.auxiliary;
  return end;
}

std::vector<Segment> given(const CamShapeProblem& problem, const CamRunOf& run) {
  const CamDesign made = design(problem.cam);
  std::vector<Segment> segments;
  for (std::size_t r = 0; r < run.segments.size(); ++r)
    for (std::size_t i = 0; i < made.origin.size(); ++i)
      if (made.origin[i] == run.segments[r])
        segments.push_back(scaled(made.cam.segments()[i], 1, run.knots[r + 1].auxiliary));
  return segments;
}

}  // namespace

bool meets(const Corridor& corridor, const CamRunOf& run) {
  std::vector<Corridor> parts;
  cut(corridor, run, parts);
  return !parts.empty();
}

ShapeProblem shape_problem(const CamShapeProblem& problem, const CamRunOf& run, double accuracy) {
  ShapeProblem p;
  p.begin = run.knots.front().x();
  p.end = run.knots.back().x();
  p.from = end_of(run.knots.front());
  p.to = end_of(run.knots.back());
  p.periodic = run.closed;
  p.degree = shape_of(problem, run.segments.front()).continuity + 1;
  p.pieces = pieces_of(problem, run);
  p.refine = problem.refine;
  p.given = given(problem, run);
  for (std::size_t r = 0; r < run.knots.size(); ++r)
    add_knot(run.knots[r], r > 0 && r + 1 < run.knots.size(), p.corridors);
  add_limits(problem, run, accuracy, p.corridors);
  add_monotone(problem, run, p.corridors);
  for (const Corridor& corridor : problem.corridors)
    cut(narrowed(corridor, problem, run, accuracy), run, p.corridors);
  p.ceilings = problem.ceilings;
  p.options = problem.options;
  return p;
}

}  // namespace jounce::optimize_detail
