// SPDX-License-Identifier: Apache-2.0
#include "jounce/optimize/spline_times.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

#include "jounce/profiles/curve/extrema.hpp"
#include "jounce/profiles/error.hpp"

#include "optimize/src/search/drawn.hpp"
#include "optimize/src/search/findings.hpp"
#include "optimize/src/search/joint_spline.hpp"
#include "optimize/src/search/time_search.hpp"

namespace jounce {
namespace {

using optimizer::drawn;
using optimizer::TimeAttempt;
using Points = std::vector<std::vector<double>>;

constexpr double agreement = 1e-6;

std::string point_key(std::size_t i, std::size_t joint) {
  return "points[" + std::to_string(i + 1) + "][" + std::to_string(joint + 1) + "]";
}

void require_points(const Points& points) {
  if (points.size() < 2)
    throw InputError("points", std::to_string(points.size()) + " points", "must be at least two");
  constexpr std::size_t most = 60;  // half a minute; the effort grows with the cube
  if (points.size() > most)
    throw InputError("points", std::to_string(points.size()) + " points",
                     "are too many, at most " + std::to_string(most));
  bool moves = false;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (points[i].empty() || points[i].size() != points[0].size())
      throw InputError("points[" + std::to_string(i + 1) + "]",
                       std::to_string(points[i].size()) + " positions",
                       "must be one for each joint in each point");
    for (std::size_t j = 0; j < points[i].size(); ++j) {
      require_finite(point_key(i, j).c_str(), points[i][j]);
      moves = moves || points[i][j] != points[0][j];
    }
  }
  if (!moves) throw InputError("points", "all equal", "there is no motion");
}

void require_limits(const SplineTimesSpec& spec) {
  const bool shortest = spec.objective == TimeObjective::shortest;
  const std::size_t joints = spec.points[0].size();
  if (spec.limits.empty() && !shortest) return;
  if (spec.limits.size() != joints)
    throw InputError("limits", std::to_string(spec.limits.size()),
                     "must be one for each joint: there are " + std::to_string(joints));
  for (std::size_t j = 0; j < joints; ++j) {
    const Limits& l = spec.limits[j];
    require_valid(l);
    if (shortest && !l.jerk)  // the accelerations at the ends would rise in no time
      throw InputError("limits[" + std::to_string(j + 1) + "].jerk", "",
                       "is missing: the shortest times of splines need a jerk limit");
  }
}

void require_valid(const SplineTimesSpec& spec) {
  require_points(spec.points);
  require_limits(spec);
  if (spec.starts < 1)
    throw InputError("starts", static_cast<double>(spec.starts), "must be at least 1");
  if (spec.objective != TimeObjective::shortest)
    require_positive("duration", spec.duration);
  else if (spec.duration != 0)
    throw InputError("duration", spec.duration, "is found by times = \"shortest\": leave it out");
}

/// The first: equal intervals, the outer ones a third of the others. The others: each of them times
/// 1/e to e.
std::vector<double> start(const SplineTimesSpec& spec, int which, std::uint64_t& state) {
  std::vector<double> h(spec.points.size() + 1, 3.0);
  h.front() = h.back() = 1;
  if (which > 0)
    for (double& each : h) each *= std::exp(2 * drawn(state) - 1);
  return h;
}

std::string at(const Extremum& e, std::size_t joint, const char* quantity) {
  return "joint " + std::to_string(joint + 1) + " " + quantity + " " + optimizer::brief(e.value) +
         " at " + optimizer::brief(e.where) + " s";
}

/// Peaks of one joint that are at the limit; each once, though two intervals share a knot.
void add_active(const Trajectory& f, std::size_t joint, std::size_t order, double limit,
                std::vector<std::string>& active) {
  for (std::size_t i = 0; i < f.segments().size(); ++i) {
    const Range range = segment_range(f, i, static_cast<int>(order));
    for (const Extremum& e : {range.min, range.max}) {
      if (std::abs(e.value) < limit * (1 - agreement)) continue;
      std::string words = at(e, joint, OverTime::names[order]);
      if (std::find(active.begin(), active.end(), words) == active.end())
        active.push_back(std::move(words));
    }
  }
}

std::vector<std::string> active_of(const SplineTimesSpec& spec, const SplineTimes& best) {
  std::vector<std::string> active;
  for (std::size_t j = 0; j < best.joints.size(); ++j) {
    if (spec.objective == TimeObjective::least_peak_jerk)
      add_active(best.joints[j], j, 3, best.value, active);
    if (spec.objective != TimeObjective::shortest) continue;
    const std::array<std::optional<double>, 4> limits{
        std::nullopt, spec.limits[j].velocity, spec.limits[j].acceleration, spec.limits[j].jerk};
    for (std::size_t order = 1; order < 4; ++order)
      if (limits[order]) add_active(best.joints[j], j, order, *limits[order], active);
  }
  return active;
}

Report check_all(const SplineTimesSpec& spec, const std::vector<Trajectory>& joints) {
  Report all;
  for (std::size_t j = 0; j < spec.limits.size(); ++j)
    for (Finding& finding : check(joints[j], spec.limits[j]).findings) {
      finding.axis = "joint " + std::to_string(j + 1);
      all.findings.push_back(std::move(finding));
    }
  sort(all);
  return all;
}

void judge(const std::vector<TimeAttempt>& attempts, SplineTimes& best) {
  const double value = attempts.front().value;
  best.agreeing = static_cast<int>(std::count_if(
      attempts.begin(), attempts.end(),
      [&](const TimeAttempt& each) { return each.value <= value * (1 + agreement); }));
  best.spread = attempts.size() > 1 ? attempts[1].value / value - 1 : 0;
  const std::string of = " of " + std::to_string(attempts.size()) + " starts";
  best.status = best.agreeing > 1 ? SplineTimes::Status::converged : SplineTimes::Status::stalled;
  best.reason = best.agreeing > 1
                    ? std::to_string(best.agreeing) + of + " agree to 1e-6, the best two to " +
                          optimizer::brief(best.spread) + "; a local search is no proof"
                    : "only one" + of + " found this result: more starts may find a better one";
}

}  // namespace

const char* name(SplineTimes::Status status) {
  return status == SplineTimes::Status::converged ? "converged" : "stalled";
}

std::vector<Trajectory> spline_through(const Points& points, const std::vector<double>& intervals) {
  require_points(points);
  if (intervals.size() != points.size() + 1)
    throw InputError("intervals", std::to_string(intervals.size()),
                     "must be one more than points: " + std::to_string(points.size() + 1));
  for (std::size_t i = 0; i < intervals.size(); ++i)
    require_positive(("intervals[" + std::to_string(i + 1) + "]").c_str(), intervals[i]);
  std::vector<Trajectory> joints;
  for (std::size_t j = 0; j < points[0].size(); ++j) {
    std::vector<double> positions;
    for (const auto& point : points) positions.push_back(point[j]);
    const auto s = optimizer::joint_spline<double>(positions, intervals);
    std::vector<Segment> segments;
    for (std::size_t i = 0; i < intervals.size(); ++i)
      segments.push_back(
          cubic(intervals[i], s.position[i], s.velocity[i], s.position[i + 1], s.velocity[i + 1]));
    joints.emplace_back(std::move(segments), 0, Extrapolation::hold);
  }
  return joints;
}

SplineTimes spline_times(const SplineTimesSpec& spec) {
  require_valid(spec);
  std::uint64_t state = spec.seed;
  std::vector<TimeAttempt> attempts;
  SplineTimes best;
  for (int i = 0; i < spec.starts; ++i) {
    attempts.push_back(optimizer::improve(spec, start(spec, i, state)));
    best.evaluations += attempts.back().evaluations;
  }
  std::stable_sort(attempts.begin(), attempts.end(),
                   [](const TimeAttempt& a, const TimeAttempt& b) { return a.value < b.value; });
  best.value = attempts.front().value;
  best.intervals = attempts.front().intervals;
  best.duration = std::accumulate(best.intervals.begin(), best.intervals.end(), 0.0);
  best.joints = spline_through(spec.points, best.intervals);
  best.limits = check_all(spec, best.joints);
  best.active = active_of(spec, best);
  judge(attempts, best);
  return best;
}

}  // namespace jounce
