// SPDX-License-Identifier: Apache-2.0
#include "jounce/optimize/cam_shape.hpp"

#include <algorithm>
#include <cmath>

#include "jounce/profiles/error.hpp"

#include "optimize/src/shapes/cam_run.hpp"
#include "optimize/src/shapes/not_convex.hpp"
#include "optimize/src/shapes/optimized_from.hpp"
#include "optimize/src/shapes/shape_report.hpp"
#include "optimize/src/tolerances.hpp"

namespace jounce {
namespace {

using Status = OptimizeStatus;
using optimize_detail::CamRunOf;

/// Share of the given value of a figure: permits a later stage where the least value of an earlier figure is 0.
constexpr double least_concession = 1e-6;

/// Relative accuracy of positions: of doubles, and of the joints of a spline after an iteration.
constexpr double rounding = 1.2e-16;
constexpr double joints = 1e-11;

/// Passes on the progress of one stage of one run as progress of the whole.
struct Watch {
  const KeepGoing& keep_going;
  std::size_t run = 0;
  std::size_t runs = 0;
  std::size_t stage = 0;
  std::size_t stages = 0;

  bool operator()(OptimizeProgress progress) const {
    if (!keep_going) return true;
    const auto before = static_cast<double>(run * stages + stage);
    progress.done = (before + progress.done) / static_cast<double>(runs * stages);
    progress.run = run;
    progress.runs = runs;
    progress.stage = stage;
    return keep_going(progress);
  }
};

std::vector<Ceiling> kept(const CamShapeProblem& problem, const std::vector<FigureResult>& stages) {
  std::vector<Ceiling> ceilings = problem.ceilings;
  for (std::size_t i = 0; i < stages.size(); ++i)
    ceilings.push_back(
        {problem.minimize[i].front().figure,
         stages[i].reached * (1 + problem.concession) + least_concession * stages[i].given});
  return ceilings;
}

/// The result for one figure of a run.
FigureResult result_of(ShapeProblem run, const ShapeFigure& figure,
                       const std::vector<Segment>& shape) {
  run.minimize = {{figure}};
  run.ceilings.clear();
  const auto given = optimize_detail::needs_search(run) ? optimize_detail::given_as_spline(run)
                                                        : optimize_detail::given_shape(run);
  const optimize_detail::ShapeModel model(run, optimize_detail::knots_of(run, shape), given);
  return optimize_detail::figure_results(run, model.space, given, shape).front();
}

/// The figures of all entries of `minimize`, including those that were not reached, then those of the ceilings.
std::vector<FigureResult> figures_of(const CamShapeProblem& problem, const ShapeProblem& run,
                                     const std::vector<Segment>& shape) {
  std::vector<FigureResult> figures;
  for (const auto& stage : problem.minimize)
    for (const WeightedFigure& m : stage) figures.push_back(result_of(run, m.figure, shape));
  for (const Ceiling& c : problem.ceilings) figures.push_back(result_of(run, c.figure, shape));
  return figures;
}

/// Minimizes one entry of `minimize` after the other. If one fails, the result of the one before stands.
ShapeOutcome minimized(const CamShapeProblem& problem, ShapeProblem& run, Watch& watch) {
  ShapeOutcome best;
  std::vector<FigureResult> stages;  // results of the earlier entries
  for (std::size_t stage = 0; stage < problem.minimize.size(); ++stage) {
    watch.stage = stage;
    run.minimize = problem.minimize[stage];
    run.ceilings = kept(problem, stages);
    ShapeOutcome found = optimize_detail::optimized_from(run, best.best, watch);
    if (stage > 0 && !found.usable()) {
      best.status = found.status == Status::cancelled ? found.status : Status::stalled;
      best.reason = name(problem.minimize[stage].front().figure) +
                    " was not improved without a loss of the earlier figures: " + found.reason;
      return best;
    }
    best = std::move(found);
    if (!best.usable() || best.status == Status::cancelled) return best;
    stages.push_back(best.figures.front());
  }
  return best;
}

CamRunOutcome optimized(const CamShapeProblem& problem, const CamRunOf& run, ShapeProblem shape,
                        Watch& watch) {
  CamRunOutcome outcome{run.segments, minimized(problem, shape, watch)};
  if (outcome.shape.best.empty()) return outcome;
  outcome.shape.figures = figures_of(problem, shape, outcome.shape.best);
  for (Finding& finding : optimize_detail::kept_jerks(run))
    outcome.shape.active.push_back(std::move(finding));
  return outcome;
}

/// check() of the cam as designed, with the segments of the spec.
Report limits_of(const CamSpec& cam, const Limits& limits) {
  const CamDesign made = design(cam);
  Report report = check(made.cam, limits);
  for (Finding& finding : report.findings)
    if (finding.segment) finding.segment = made.origin[*finding.segment];
  return report;
}

/// Combines the outcomes of the runs.
void sum_up(CamShapeOutcome& outcome) {
  outcome.status = Status::optimal;
  outcome.feasible = outcome.limits.ok();
  for (const CamRunOutcome& run : outcome.runs) {
    const ShapeOutcome& shape = run.shape;
    if (outcome.reason.empty() || shape.status > outcome.status) {
      outcome.status = shape.status;
      outcome.reason = shape.reason;
    }
    outcome.feasible = outcome.feasible && shape.feasible;
    outcome.figures.insert(outcome.figures.end(), shape.figures.begin(), shape.figures.end());
    outcome.active.insert(outcome.active.end(), shape.active.begin(), shape.active.end());
    outcome.evaluations += shape.evaluations;
    outcome.rounds += shape.rounds;
  }
  if (outcome.runs.size() != 1) return;
  outcome.value = outcome.runs.front().shape.value;
  outcome.bound = outcome.runs.front().shape.bound;
}

/// True if a segment that begins at x keeps a corridor, to the digits of `check`.
bool keeps(const Corridor& corridor, const Segment& segment, double x) {
  if (corridor.from == corridor.to || x + segment.length > corridor.to * (1 + rounding) ||
      x < corridor.from * (1 - rounding))
    return true;
  const Range range = segment_range(optimize_detail::quantity_of(corridor.quantity, segment), x,
                                    x + segment.length, 0);
  const auto flat = [](const std::optional<Edge>& edge) {
    return edge && edge->at_from == edge->at_to;
  };
  return !(flat(corridor.upper) &&
           range.max.value > corridor.upper->at_from + optimize_detail::rounding_tolerance *
                                                           std::abs(corridor.upper->at_from)) &&
         !(flat(corridor.lower) &&
           range.min.value < corridor.lower->at_from - optimize_detail::rounding_tolerance *
                                                           std::abs(corridor.lower->at_from));
}

/// True if the segments of a run keep the corridors of derivatives as designed.
bool keeps_corridors(const CamSpec& cam, const std::vector<Corridor>& corridors,
                     const CamRunOf& run) {
  const CamDesign made = design(cam);
  for (const Corridor& corridor : corridors)
    for (std::size_t i = 0; i < made.origin.size(); ++i)
      if (corridor.quantity.by[0] == 0 &&
          std::count(run.segments.begin(), run.segments.end(), made.origin[i]) > 0 &&
          !keeps(corridor, made.cam.segments()[i], made.cam.breaks()[i]))
        return false;
  return true;
}

/// True if the segments of a run keep the limits as designed.
bool keeps_limits(const CamSpec& cam, const CamShapeProblem& problem, const CamRunOf& run) {
  if (!keeps_corridors(cam, problem.corridors, run)) return false;
  const Report report = limits_of(cam, problem.limits);
  return std::none_of(report.findings.begin(), report.findings.end(), [&](const Finding& f) {
    return f.broken && f.segment &&
           std::count(run.segments.begin(), run.segments.end(), *f.segment) > 0;
  });
}

/// Optimizes one run and writes it to outcome.best. A spline that keeps the limits may break them in the last
/// digits when it is written as points. Then the run is optimized again with tighter limits.
void take_run(const CamShapeProblem& problem, const CamRunOf& run, Watch& watch,
              CamShapeOutcome& outcome) {
  const double parts = static_cast<double>(watch.runs * watch.stages);
  CamRunOutcome found;
  CamSpec best = outcome.best;
  for (const double accuracy : {rounding, joints, 100 * joints}) {
    ShapeProblem shape = optimize_detail::shape_problem(problem, run, accuracy);
    if (problem.options.budget.seconds)
      shape.options.budget.seconds = *problem.options.budget.seconds / parts;
    found = optimized(problem, run, shape, watch);
    if (found.shape.best.empty()) break;
    best = optimize_detail::with_shape(outcome.best, run, shape, found.shape.best);
    if (!found.shape.usable() || keeps_limits(best, problem, run)) break;
  }
  outcome.best = std::move(best);
  outcome.runs.push_back(std::move(found));
}

}  // namespace

CamShapeOutcome optimize_cam_shapes(const CamShapeProblem& problem, const KeepGoing& keep_going) {
  require_valid(problem);
  const auto runs = optimize_detail::runs_of(problem);
  CamShapeOutcome outcome;
  outcome.best = problem.cam;
  Watch watch{.keep_going = keep_going, .runs = runs.size(), .stages = problem.minimize.size()};
  for (std::size_t i = 0; i < runs.size(); ++i) {
    watch.run = i;
    take_run(problem, runs[i], watch, outcome);
  }
  outcome.limits = limits_of(outcome.best, problem.limits);
  sum_up(outcome);
  return outcome;
}

}  // namespace jounce
