// SPDX-License-Identifier: Apache-2.0
// From a cam with free segments to its runs: their segments, and the fixed values of their knots.
#include "optimize/src/shapes/cam_run.hpp"

#include <algorithm>
#include <cmath>

#include "jounce/profiles/curve/extrema.hpp"

namespace jounce::optimize_detail {
namespace {

constexpr double no_step = 1e-9;  // relative to the peak jerk: permits rounded input
constexpr double joined_to =
    1e-12;  // relative accuracy of the positions where pieces of a spline join

std::vector<std::vector<std::size_t>> grouped(const CamShapeProblem& problem) {
  std::vector<std::vector<std::size_t>> groups;
  for (const FreeShape& shape : problem.shapes) {
    if (groups.empty() || groups.back().back() + 1 != shape.segment) groups.emplace_back();
    groups.back().push_back(shape.segment);
  }
  const bool over_seam = problem.cam.periodic && groups.size() > 1 && groups.front().front() == 0 &&
                         groups.back().back() + 1 == problem.cam.segments.size();
  if (over_seam) {
    groups.back().insert(groups.back().end(), groups.front().begin(), groups.front().end());
    groups.erase(groups.begin());
  }
  return groups;
}

/// The freedom of a knot. The start and the last knot of a periodic cam are one.
FreeKnot freedom(const CamShapeProblem& problem, std::size_t knot) {
  const std::size_t last = problem.cam.segments.size();
  for (const FreeKnot& free : problem.knots) {
    const bool seam = problem.cam.periodic && free.knot % last == 0 && knot % last == 0;
    if (free.knot == knot || seam) return free;
  }
  return {};
}

/// The pieces of a cam before and after a place; none beyond an end of a cam that holds.
struct Sides {
  const Segment* before = nullptr;
  const Segment* after = nullptr;
};

/// Uses the nearest break: a break is a sum of lengths and may differ from the master in the last digit.
Sides sides(const Cam& cam, double master) {
  const auto breaks = cam.breaks();
  const auto nearest = std::min_element(breaks.begin(), breaks.end(), [&](double a, double b) {
    return std::abs(a - master) < std::abs(b - master);
  });
  const auto i = static_cast<std::size_t>(nearest - breaks.begin());
  const auto pieces = cam.segments();
  const bool wraps = cam.outside() != Extrapolation::hold;
  Sides s;
  if (i > 0 || wraps) s.before = &pieces[(i + pieces.size() - 1) % pieces.size()];
  if (i < pieces.size() || wraps) s.after = &pieces[i % pieces.size()];
  return s;
}

/// Returns the jerk at an end of a run, or no value if the jerk steps there. Beyond the end of a
/// cam that holds its position the jerk is 0. Steps due to rounding do not count: an error e of a
/// position at one end of a piece of length h changes its jerk by 60 e / h^3.
std::optional<double> steady_jerk(const Cam& cam, double master) {
  const Sides beside = sides(cam, master);
  const Range slave = extrema(cam, 0);
  const double error = joined_to * std::max(std::abs(slave.min.value), std::abs(slave.max.value));
  const double before = beside.before ? evaluate(*beside.before, 1)[3] : 0;
  const double after = beside.after ? evaluate(*beside.after, 0)[3] : 0;
  double step = no_step * std::abs(extrema(cam, 3).peak().value);
  for (const Segment* piece : {beside.before, beside.after})
    if (piece) step += 60 * error / std::pow(piece->length, 3);
  if (std::abs(after - before) > step) return std::nullopt;
  return std::max(std::abs(before), std::abs(after)) > step ? before : 0;
}

RunKnot knot_of(const CamShapeProblem& problem, const std::vector<CamKnot>& resolved,
                std::size_t knot) {
  RunKnot k;
  k.knot = knot;
  k.master = resolved[knot].master;
  k.free = freedom(problem, knot);
  if (!k.free.slave) k.slave = resolved[knot].slave;
  if (!k.free.geo_velocity) k.geo_velocity = resolved[knot].geo_velocity;
  if (!k.free.geo_acceleration) k.geo_acceleration = resolved[knot].geo_acceleration;
  return k;
}

CamRunOf run_of(const CamShapeProblem& problem, std::vector<std::size_t> segments) {
  const auto resolved = resolved_knots(problem.cam);
  const Cam cam = design(problem.cam).cam;
  CamRunOf run;
  run.start = cam.start();
  run.length = cam.length();
  run.advance = resolved.back().slave - resolved.front().slave;
  run.closed = problem.cam.periodic && segments.size() == problem.cam.segments.size();
  run.segments = std::move(segments);
  run.knots.push_back(knot_of(problem, resolved, run.segments.front()));
  for (const std::size_t i : run.segments) {
    RunKnot knot = knot_of(problem, resolved, i + 1);
    if (i < run.segments.front()) {
      knot.ahead = run.length;
      knot.auxiliary = run.advance;
    }
    run.knots.push_back(knot);
  }
  if (run.closed || problem.shapes.front().continuity < 3) return run;
  const auto fix = [&](RunKnot& end, std::size_t segment) {
    const EndJerk wanted = shape_of(problem, segment).end_jerk;
    if (wanted == EndJerk::zero) end.geo_jerk = 0;
    if (wanted == EndJerk::as_given && !end.free.geo_acceleration)
      end.geo_jerk = steady_jerk(cam, end.master);
  };
  fix(run.knots.front(), run.segments.front());
  fix(run.knots.back(), run.segments.back());
  return run;
}

}  // namespace

const FreeShape& shape_of(const CamShapeProblem& problem, std::size_t segment) {
  return *std::find_if(problem.shapes.begin(), problem.shapes.end(),
                       [&](const FreeShape& s) { return s.segment == segment; });
}

std::vector<Finding> kept_jerks(const CamRunOf& run) {
  std::vector<Finding> all;
  const auto add = [&](const RunKnot& end, std::size_t segment) {
    if (!end.geo_jerk) return;
    Finding& f = all.emplace_back();
    f.rule = "kept/geo_jerk";
    f.quantity = "geo_jerk";
    f.where = end.x();
    f.value = f.limit = *end.geo_jerk;
    f.segment = segment;
  };
  add(run.knots.front(), run.segments.front());
  add(run.knots.back(), run.segments.back());
  return all;
}

std::vector<CamRunOf> runs_of(const CamShapeProblem& problem) {
  std::vector<CamRunOf> runs;
  for (auto& segments : grouped(problem)) runs.push_back(run_of(problem, std::move(segments)));
  return runs;
}

}  // namespace jounce::optimize_detail
