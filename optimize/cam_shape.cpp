#include "jounce/optimize/cam_shape.hpp"

#include <algorithm>
#include <cmath>

#include "jounce/optimize/detail/cam_run.hpp"
#include "jounce/profiles/error.hpp"

namespace jounce {
namespace {

using Status = Outcome::Status;
using detail::CamRunOf;

/// So that what was minimised may still be met where its least value is 0: of its given value.
constexpr double least_concession = 1e-6;

/// How true positions are, relative: of doubles, and of the joints of a spline from an iteration.
constexpr double rounding = 1.2e-16;
constexpr double joints = 1e-11;

struct Watch {
  const CamShapeKeepGoing& keep_going;
  CamShapeProgress progress;

  bool operator()(int round, double value) {
    progress.round = round;
    progress.value = value;
    return !keep_going || keep_going(progress);
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

/// The figures of all stages with what became of them, then those of the ceilings.
std::vector<FigureResult> figures_of(const CamShapeProblem& problem,
                                     std::vector<FigureResult> stages, const ShapeOutcome& last,
                                     std::size_t done) {
  const std::size_t own = problem.minimize[done - 1].size();
  std::vector<FigureResult> figures = std::move(stages);
  for (std::size_t i = 0; i < figures.size(); ++i)
    if (own + problem.ceilings.size() + i < last.figures.size())
      figures[i].reached = last.figures[own + problem.ceilings.size() + i].reached;
  for (std::size_t i = 0; i < own + problem.ceilings.size() && i < last.figures.size(); ++i)
    figures.push_back(last.figures[i]);
  return figures;
}

CamRunOutcome optimized(const CamShapeProblem& problem, const CamRunOf& run, ShapeProblem shape,
                        Watch& watch) {
  CamRunOutcome outcome{run.segments, {}, {}};
  std::vector<FigureResult> stages;  // of those before
  for (std::size_t stage = 0; stage < problem.minimize.size(); ++stage) {
    watch.progress.stage = stage;
    shape.minimize = problem.minimize[stage];
    shape.ceilings = kept(problem, stages);
    ShapeOutcome found =
        optimize_shape(shape, [&](int round, double value) { return watch(round, value); });
    if (stage > 0 && !found.usable()) {  // what was reached before stands
      outcome.shape.status = found.status == Status::cancelled ? found.status : Status::stalled;
      outcome.shape.reason = name(problem.minimize[stage].front().figure) +
                             " was not improved beside what was minimised before: " + found.reason;
      return outcome;
    }
    outcome.shape = std::move(found);
    outcome.figures = figures_of(problem, stages, outcome.shape, stage + 1);
    if (!outcome.shape.usable() || outcome.shape.status == Status::cancelled) return outcome;
    if (!outcome.shape.figures.empty()) stages.push_back(outcome.shape.figures.front());
  }
  return outcome;
}

/// check() of the cam as designed, told by the segments of the spec.
Report limits_of(const CamSpec& cam, const Limits& limits) {
  const CamDesign made = design(cam);
  Report report = check(made.cam, limits);
  for (Finding& finding : report.findings)
    if (finding.segment) finding.segment = made.origin[*finding.segment];
  return report;
}

int badness(Status status) {
  switch (status) {
    case Status::optimal:
      return 0;
    case Status::converged:
      return 1;
    case Status::stalled:
      return 2;
    case Status::cancelled:
      return 3;
    case Status::infeasible:
      break;
  }
  return 4;
}

}  // namespace

bool CamShapeOutcome::usable() const {
  return !runs.empty() && limits.ok() &&
         std::all_of(runs.begin(), runs.end(), [](const auto& r) { return r.shape.usable(); });
}

namespace {

/// Whether the segments of a run keep the limits as designed.
bool keeps_limits(const CamSpec& cam, const Limits& limits, const CamRunOf& run) {
  const Report report = limits_of(cam, limits);
  return std::none_of(report.findings.begin(), report.findings.end(), [&](const Finding& f) {
    return f.broken && f.segment &&
           std::count(run.segments.begin(), run.segments.end(), *f.segment) > 0;
  });
}

/// Optimises one run and puts it into outcome.best. What keeps the limits as a spline may break them in
/// the last digits as points: then once more, by as much below.
void take_run(const CamShapeProblem& problem, const CamRunOf& run, Watch& watch,
              CamShapeOutcome& outcome) {
  const double parts = static_cast<double>(watch.progress.runs * watch.progress.stages);
  CamRunOutcome found;
  CamSpec best = outcome.best;
  for (const double accuracy : {rounding, joints}) {
    ShapeProblem shape = detail::shape_problem(problem, run, accuracy);
    if (problem.seconds) shape.seconds = *problem.seconds / parts;
    found = optimized(problem, run, shape, watch);
    if (found.shape.segments.empty()) break;
    best = detail::with_shape(outcome.best, run, shape, found.shape.segments);
    if (!found.shape.usable() || keeps_limits(best, problem.limits, run)) break;
  }
  outcome.best = std::move(best);
  outcome.runs.push_back(std::move(found));
}

}  // namespace

CamShapeOutcome optimize_cam_shapes(const CamShapeProblem& problem,
                                    const CamShapeKeepGoing& keep_going) {
  require_valid(problem);
  const auto runs = detail::runs_of(problem);
  CamShapeOutcome outcome;
  outcome.best = problem.cam;
  Watch watch{keep_going, {}};
  watch.progress.runs = runs.size();
  watch.progress.stages = problem.minimize.size();
  for (std::size_t i = 0; i < runs.size(); ++i) {
    watch.progress.run = i;
    take_run(problem, runs[i], watch, outcome);
  }
  const auto worst =
      std::max_element(outcome.runs.begin(), outcome.runs.end(), [](const auto& a, const auto& b) {
        return badness(a.shape.status) < badness(b.shape.status);
      });
  outcome.status = worst->shape.status;
  outcome.reason = worst->shape.reason;
  outcome.limits = limits_of(outcome.best, problem.limits);
  return outcome;
}

}  // namespace jounce
