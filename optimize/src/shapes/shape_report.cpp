// SPDX-License-Identifier: Apache-2.0
#include "optimize/src/shapes/shape_report.hpp"

#include <algorithm>
#include <cmath>

#include "optimize/src/tolerances.hpp"

namespace jounce::optimize_detail {
namespace {

constexpr double at_the_edge = 1e-6;  ///< share of a segment: a window has knots at both ends
constexpr double missed_share =
    1e-7;  ///< share of the size of a derivative above which a difference is a step
constexpr double left_by_a_solver =
    1e-4;                        ///< relative excess that lower_exceeded() treats as rounding
constexpr double solved = 1e-9;  ///< share of the size of a quantity that a solver leaves

Finding finding(Rule rule, const std::string& quantity, const Extremum& e, double limit,
                double margin, std::size_t piece, double rounding = rounding_tolerance) {
  return {.rule = std::move(rule),
          .axis = "",
          .quantity = quantity,
          .where = e.where,
          .value = e.value,
          .limit = limit,
          .margin = margin,
          .broken = margin < -rounding,
          .segment = piece,
          .advice = ""};
}

/// The unit of the margin of a corridor: the size of its edges, or of the quantity where they are 0.
double scale_of(const Corridor& c, double natural) {
  double scale = 0;
  for (const auto& edge : {c.lower, c.upper})
    if (edge) scale = std::max({scale, std::abs(edge->at_from), std::abs(edge->at_to)});
  return scale > solved * natural ? scale : natural;
}

/// Every piece of a corridor's window, or the part of it, with its closest approach to one edge.
/// `natural`: the size of the quantity.
template <class Visit>
void each_approach(const Corridor& c, const std::vector<Segment>& shape, double begin,
                   double natural, const Visit& visit) {
  const double scale = scale_of(c, natural);
  double x = begin;
  for (std::size_t i = 0; i < shape.size(); ++i) {
    const double end =
        i + 1 == shape.size() ? std::max(x + shape[i].length, c.to) : x + shape[i].length;
    const double near =
        at_the_edge * shape[i].length;  // there are knots at both ends of the window
    const double from = std::max(x, c.from);
    const double to = std::min(end, c.to);
    const bool point = c.from == c.to && from == to && (c.from < end || i + 1 == shape.size());
    if (point || to - from > near) {
      const double s0 = std::clamp((from - x) / shape[i].length, 0.0, 1.0);
      const double s1 = std::clamp((to - x) / shape[i].length, 0.0, 1.0);
      for (const auto& [sign, edge] : {std::pair{1.0, c.upper}, {-1.0, c.lower}}) {
        if (!edge) continue;
        const Segment q = quantity_of(c.quantity, shape[i]);
        Segment room = s0 == s1 ? line(1, value(q, s0), value(q, s0)) : part(q, s0, s1);
        room.degree = std::max(room.degree, 1);
        const double first = edge_at(c, *edge, from);
        room.c[0] -= first;
        room.c[1] -= edge_at(c, *edge, to) - first;
        const Range range = segment_range(room, from, std::max(to, from), 0);
        Extremum e = sign > 0 ? range.max : range.min;
        const double limit = edge_at(c, *edge, e.where);
        const double unit = std::max(scale, std::abs(limit));
        const double margin = -sign * e.value / unit;
        e.value += limit;
        visit(i, sign,
              finding("limit/" + c.quantity.name, c.quantity.name, e, limit, margin, i,
                      rounding_tolerance + solved * natural / unit));
      }
    }
    x = end;
  }
}

/// Findings where the finished segments miss the fixed values at the ends or a joint, in the units of
/// SplineSpace.
void add_missed(const ShapeProblem& problem, const ShapeModel& model,
                const std::vector<Segment>& shape, std::vector<Finding>& findings) {
  const auto expect = [&](const char* rule, std::size_t knot, std::size_t k, double value,
                          double wanted) {
    const double off = std::abs(value - wanted);
    const double size = model.space.unit(knot, static_cast<int>(k));
    if (off <= missed_share * size + rounding_tolerance * std::abs(wanted)) return;
    const Extremum e{value, model.space.knots()[knot], Side::right};
    const std::string quantity = derivative_of_shape(static_cast<int>(k)).name;
    findings.push_back(finding(rule + quantity, quantity, e, wanted,
                               -off / std::max(std::abs(wanted), size),
                               std::min(knot, shape.size() - 1)));
  };
  const auto from = derivatives_of(problem.from);
  const auto to = derivatives_of(problem.to);
  const Jet first = evaluate(shape.front(), 0);
  const Jet last = evaluate(shape.back(), 1);
  for (std::size_t k = 0; k < first.size() && static_cast<int>(k) < problem.degree; ++k) {
    if (from[k]) expect("fixed/", 0, k, first[k], *from[k]);
    if (to[k]) expect("fixed/", model.space.pieces(), k, last[k], *to[k]);
  }
  if (shape.size() != model.space.pieces()) return;
  for (std::size_t i = 0; i + 1 < shape.size(); ++i) {
    const Jet before = evaluate(shape[i], 1);
    const Jet after = evaluate(shape[i + 1], 0);
    for (std::size_t k = 0; k < 3 && static_cast<int>(k) < problem.degree; ++k)
      expect("joint/", i + 1, k, after[k], before[k]);
  }
}

/// The peak of a figure, with its place if it has one.
Extremum figure_peak(const ShapeFigure& figure, const FigureRows& rows, double begin,
                     const std::vector<Segment>& shape) {
  if (const auto* f = std::get_if<PeakOf>(&figure)) return peak_of(f->quantity, shape, begin);
  return {rows.value(shape), begin, Side::right};
}

std::size_t piece_at(const ShapeModel& model, double x) {
  return model.space.piece_at(x);
}

}  // namespace

std::vector<FigureResult> figure_results(const ShapeProblem& problem, const SplineSpace& space,
                                         const std::vector<Segment>& given,
                                         const std::vector<Segment>& shape) {
  std::vector<FigureResult> all;
  const auto add = [&](const ShapeFigure& figure) {
    const FigureRows rows = figure_rows(figure, space);
    all.push_back({rows.name, rows.value(given), rows.value(shape), known_bound(problem, figure)});
  };
  for (const WeightedFigure& m : problem.minimize) add(m.figure);
  for (const jounce::Ceiling& c : problem.ceilings) add(c.figure);
  return all;
}

Report checked(const ShapeProblem& problem, const ShapeModel& model,
               const std::vector<Segment>& shape) {
  Report report;
  for (const Corridor& c : problem.corridors) {
    std::optional<Finding> closest;
    each_approach(c, shape, problem.begin, model.space.natural(c.quantity),
                  [&](std::size_t, double, const Finding& f) {
                    if (!closest || f.margin < closest->margin) closest = f;
                  });
    if (closest) report.findings.push_back(*closest);
  }
  for (const jounce::Ceiling& c : problem.ceilings) {
    const FigureRows rows = figure_rows(c.figure, model.space);
    const Extremum e = figure_peak(c.figure, rows, problem.begin, shape);
    const double scale = c.at_most > 0 ? c.at_most : rows.natural;
    report.findings.push_back(
        finding("limit/" + rows.name, rows.name, e, std::copysign(c.at_most, e.value),
                (c.at_most - std::abs(e.value)) / scale, piece_at(model, e.where), solved));
  }
  add_missed(problem, model, shape, report.findings);
  sort(report);
  return report;
}

bool lower_exceeded(const ShapeProblem& problem, const ShapeModel& model,
                    const std::vector<Segment>& shape, ShapeProblem& held) {
  const Report report = checked(problem, model, shape);
  if (report.ok() || report.findings.front().margin < -left_by_a_solver) return false;
  bool lowered = false;
  for (std::size_t k = 0; k < problem.corridors.size(); ++k) {
    const Corridor& c = problem.corridors[k];
    if (is_exact(c)) continue;
    double above = 0, below = 0;
    each_approach(c, shape, problem.begin, model.space.natural(c.quantity),
                  [&](std::size_t, double sign, const Finding& f) {
                    double& excess = sign > 0 ? above : below;
                    if (f.broken) excess = std::max(excess, std::abs(f.value - f.limit));
                  });
    const auto move = [&](std::optional<Edge>& edge, double by) {
      if (by == 0 || !edge) return;
      edge->at_from += by;
      edge->at_to += by;
      lowered = true;
    };
    move(held.corridors[k].upper, -2 * above);
    move(held.corridors[k].lower, 2 * below);
  }
  for (std::size_t k = 0; k < problem.ceilings.size(); ++k) {
    const jounce::Ceiling& c = problem.ceilings[k];
    const double excess = figure_rows(c.figure, model.space).value(shape) - c.at_most;
    if (excess <= solved * c.at_most || 2 * excess >= c.at_most) continue;
    held.ceilings[k].at_most -= 2 * excess;
    lowered = true;
  }
  return lowered;
}

std::vector<Finding> active(const ShapeProblem& problem, const ShapeModel& model,
                            const std::vector<Segment>& shape) {
  std::vector<Finding> all;
  for (const Corridor& c : problem.corridors) {
    std::array<std::size_t, 2> last{shape.size() + 1, shape.size() + 1};
    each_approach(c, shape, problem.begin, model.space.natural(c.quantity),
                  [&](std::size_t i, double sign, const Finding& f) {
                    if (std::abs(f.margin) > active_tolerance || is_exact(c)) return;
                    const std::size_t k = sign > 0 ? 0 : 1;
                    if (last[k] + 1 != i) all.push_back(f);
                    last[k] = i;
                  });
  }
  const auto add = [&](const std::string& kind, const ShapeFigure& figure, const FigureRows& rows,
                       double level) {
    std::vector<Extremum> places;
    if (rows.places) places = rows.places(shape, level * (1 - active_tolerance));
    if (places.empty()) places.push_back(figure_peak(figure, rows, problem.begin, shape));
    for (const Extremum& e : places)
      all.push_back(finding(kind + rows.name, rows.name, e, std::copysign(level, e.value), 0,
                            piece_at(model, e.where)));
  };
  for (const jounce::Ceiling& c : problem.ceilings) {
    const FigureRows rows = figure_rows(c.figure, model.space);
    if (rows.value(shape) >= c.at_most * (1 - active_tolerance))
      add("limit/", c.figure, rows, c.at_most);
  }
  for (const WeightedFigure& m : problem.minimize) {
    const FigureRows rows = figure_rows(m.figure, model.space);
    if (const double level = rows.value(shape); level > 0) add("objective/", m.figure, rows, level);
  }
  return all;
}

}  // namespace jounce::optimize_detail
