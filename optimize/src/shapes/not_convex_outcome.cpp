// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "optimize/src/program/shape_exchange.hpp"
#include "optimize/src/search/findings.hpp"
#include "optimize/src/shapes/not_convex.hpp"
#include "optimize/src/shapes/shape_report.hpp"

namespace jounce::optimize_detail {
namespace {

/// True if every minimized figure is within the tolerance of a proven bound.
bool at_bound(const ShapeProblem& problem, const ShapeOutcome& out) {
  for (std::size_t k = 0; k < problem.minimize.size(); ++k) {
    const FigureResult& r = out.figures[k];
    if (!r.bound || r.reached > *r.bound * (1 + problem.options.tolerance)) return false;
  }
  return true;
}

/// The remaining gap of the figures as a sentence.
std::string gap_text(const ShapeOutcome& out) {
  for (const FigureResult& r : out.figures)
    if (r.bound && r.reached > 0)
      return "no start gave a better result; at most " + brief(100 * (1 - *r.bound / r.reached)) +
             " % of " + r.name + " could still be saved";
  return "no start gave a better result; the problem is not convex, and no bound is known";
}

void set_status(const ShapeProblem& problem, const NotConvexResult& found, ShapeOutcome& out) {
  using End = NotConvexResult::End;
  using Status = OptimizeStatus;
  const auto answer = [&](Status status, std::string reason) {
    out.status = status;
    out.reason = std::move(reason);
  };
  if (found.end == End::cancelled) return answer(Status::cancelled, "stopped by the caller");
  if (found.end == End::infeasible) return answer(Status::infeasible, found.why);
  if (!out.limits.ok())
    return answer(Status::stalled, "the shape found breaks a limit: " +
                                       broken_sentence(out.limits.findings.front()));
  if (at_bound(problem, out))
    return answer(Status::optimal,
                  "no other motion is better by more than the relative tolerance " +
                      brief(problem.options.tolerance));
  if (found.end == End::stalled) return answer(Status::stalled, found.why);
  answer(Status::converged, gap_text(out));
}

}  // namespace

std::vector<Segment> given_as_spline(const ShapeProblem& problem) {
  const std::vector<Segment> given = given_shape(problem);
  const bool has_sines = std::any_of(given.begin(), given.end(),
                                     [](const Segment& f) { return f.sines > 0 || f.degree > 7; });
  if (!has_sines) return given;
  ShapeProblem bare = problem;
  bare.minimize.clear();
  bare.ceilings.clear();
  bare.corridors.clear();
  const ShapeModel model(bare, first_knots(bare), given);
  return model.space.segments(model.space.coordinates(given));
}

ShapeOutcome searched(const ShapeProblem& problem, const KeepGoing& keep_going) {
  const std::vector<Segment> given = given_as_spline(problem);
  NotConvexResult found = search_shape(problem, given, keep_going);
  make_exact(problem, found.shape);
  const ShapeModel model(problem, knots_of(problem, found.shape), given);
  ShapeOutcome out;
  out.best = found.shape;
  out.rounds = found.rounds;
  out.evaluations = found.evaluations;
  out.value = weighted_sum(model, out.best);
  out.limits = checked(problem, model, out.best);
  out.figures = figure_results(problem, model.space, given, out.best);
  out.active = active(problem, model, out.best);
  out.feasible = out.limits.ok() && !out.best.empty();
  set_status(problem, found, out);
  return out;
}

}  // namespace jounce::optimize_detail
