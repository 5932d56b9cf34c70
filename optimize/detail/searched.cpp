#include <algorithm>
#include <cmath>

#include "jounce/optimize/detail/findings.hpp"
#include "jounce/optimize/detail/not_convex.hpp"
#include "jounce/optimize/detail/shape_exchange.hpp"
#include "jounce/optimize/detail/shape_report.hpp"

namespace jounce::optimizer {
namespace {

std::vector<double> knots_of(const ShapeProblem& problem, const std::vector<Segment>& shape) {
  std::vector<double> knots{problem.begin};
  for (const Segment& f : shape) knots.push_back(knots.back() + f.length);
  knots.back() = problem.end;
  return knots;
}

/// Whether every figure to be minimised is within the tolerance of a proven bound.
bool at_bound(const ShapeProblem& problem, const ShapeOutcome& out) {
  for (std::size_t k = 0; k < problem.minimize.size(); ++k) {
    const FigureResult& r = out.figures[k];
    if (!r.bound || r.reached > *r.bound * (1 + problem.tolerance)) return false;
  }
  return true;
}

/// What the bounds of the single figures leave open.
std::string gap_text(const ShapeOutcome& out) {
  for (const FigureResult& r : out.figures)
    if (r.bound && r.reached > 0)
      return "no start leads further; at most " + brief(100 * (1 - *r.bound / r.reached)) +
             " % of " + r.name + " could still be saved";
  return "no start leads further; the problem is not convex, and no bound is known";
}

void set_status(const ShapeProblem& problem, const NotConvexResult& found, ShapeOutcome& out) {
  using End = NotConvexResult::End;
  using Status = Outcome::Status;
  const auto answer = [&](Status status, std::string reason) {
    out.status = status;
    out.reason = std::move(reason);
  };
  if (found.end == End::cancelled) return answer(Status::cancelled, "stopped by the caller");
  if (found.end == End::infeasible) return answer(Status::infeasible, found.why);
  if (!out.limits.ok())
    return answer(Status::stalled,
                  "the shape found breaks a limit: " + sentence(out.limits.findings.front()));
  if (at_bound(problem, out))
    return answer(Status::optimal,
                  "no function at all is better, to a relative " + brief(problem.tolerance));
  if (found.end == End::stalled) return answer(Status::stalled, found.why);
  answer(Status::converged, gap_text(out));
}

}  // namespace

ShapeOutcome searched(const ShapeProblem& problem, const ShapeKeepGoing& keep_going) {
  std::vector<Segment> given = given_shape(problem);
  const bool has_sines = std::any_of(given.begin(), given.end(),
                                     [](const Segment& f) { return f.sines > 0 || f.degree > 7; });
  if (has_sines) {  // products of those fit no segment: the spline with the same derivatives stands in
    ShapeProblem bare = problem;
    bare.minimize.clear();
    bare.ceilings.clear();
    bare.corridors.clear();
    const ShapeModel model(bare, first_knots(bare), given);
    given = model.space.segments(model.space.coordinates(given));
  }
  NotConvexResult found = search_shape(problem, given, keep_going);
  make_exact(problem, found.shape);
  const ShapeModel model(problem, knots_of(problem, found.shape), given);
  ShapeOutcome out;
  out.segments = found.shape;
  out.rounds = found.rounds;
  out.evaluations = found.evaluations;
  out.value = weighted_sum(model, out.segments);
  out.limits = checked(problem, model, out.segments);
  const auto add = [&](const ShapeFigure& figure) {
    const FigureRows rows = figure_rows(figure, model.space);
    out.figures.push_back(
        {rows.name, rows.value(given), rows.value(out.segments), known_bound(problem, figure)});
  };
  for (const WeightedFigure& m : problem.minimize) add(m.figure);
  for (const jounce::Ceiling& c : problem.ceilings) add(c.figure);
  out.active = active(problem, model, out.segments);
  set_status(problem, found, out);
  return out;
}

}  // namespace jounce::optimizer
