// SPDX-License-Identifier: Apache-2.0
#include "jounce/optimize/spline_times.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <numeric>
#include <utility>

#include "jounce/profiles/curve/extrema.hpp"
#include "jounce/profiles/detail/random.hpp"
#include "jounce/profiles/error.hpp"

#include "optimize/src/search/findings.hpp"
#include "optimize/src/search/joint_spline.hpp"
#include "optimize/src/search/time_search.hpp"

namespace jounce {
namespace {

using optimize_detail::TimeAttempt;
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
    if (shortest && !l.jerk)  // the accelerations at the ends would rise in zero time
      throw InputError("limits[" + std::to_string(j + 1) + "].jerk", "",
                       "is missing: the shortest times of splines need a jerk limit");
  }
}

void require_valid(const SplineTimesSpec& spec) {
  require_points(spec.points);
  require_limits(spec);
  require_valid(spec.options);
  if (spec.objective != TimeObjective::shortest)
    require_positive("duration", spec.duration);
  else if (spec.duration != 0)
    throw InputError("duration", spec.duration,
                     "is computed by times = \"shortest\": leave it out");
}

/// The intervals of a start. The first start has equal intervals, the outer ones a third of the others. In the
/// others each interval is multiplied by a factor from 1/e to e.
std::vector<double> start(const SplineTimesSpec& spec, int which, std::uint64_t& state) {
  std::vector<double> h(spec.points.size() + 1, 3.0);
  h.front() = h.back() = 1;
  if (which > 0)
    for (double& each : h) each *= std::exp(2 * profiles_detail::uniform(state) - 1);
  return h;
}

/// True if two values are equal to six digits of their size.
bool is_same(double a, double b, double size) {
  return std::abs(a - b) <= agreement * size;
}

/// Adds the peaks of one joint that are at the limit. Each is listed once, though two intervals share a knot.
void add_active(const Trajectory& f, std::size_t joint, std::size_t order, double limit,
                const char* kind, std::vector<Finding>& active) {
  const char* quantity = OverTime::names[order];
  const std::string axis = "joint " + std::to_string(joint + 1);
  for (std::size_t i = 0; i < f.segments().size(); ++i) {
    const Range range = segment_range(f, i, static_cast<int>(order));
    for (const Extremum& e : {range.min, range.max}) {
      if (std::abs(e.value) < limit * (1 - agreement)) continue;
      const bool again = std::any_of(active.begin(), active.end(), [&](const Finding& a) {
        return a.axis == axis && a.quantity == quantity && is_same(a.where, e.where, f.length()) &&
               is_same(a.value, e.value, limit);
      });
      if (again) continue;
      active.push_back({.rule = std::string(kind) + quantity,
                        .axis = axis,
                        .quantity = quantity,
                        .where = e.where,
                        .value = e.value,
                        .limit = std::copysign(limit, e.value),
                        .margin = 1 - std::abs(e.value) / limit,
                        .segment = i,
                        .advice = {}});
    }
  }
}

std::vector<Finding> active_of(const SplineTimesSpec& spec, const SplineTimesOutcome& best) {
  std::vector<Finding> active;
  for (std::size_t j = 0; j < best.best.joints.size(); ++j) {
    const Trajectory& joint = best.best.joints[j];
    if (spec.objective == TimeObjective::least_peak_jerk)
      add_active(joint, j, 3, best.value, "objective/", active);
    if (spec.objective != TimeObjective::shortest) continue;
    const std::array<std::optional<double>, 4> limits{
        std::nullopt, spec.limits[j].velocity, spec.limits[j].acceleration, spec.limits[j].jerk};
    for (std::size_t order = 1; order < 4; ++order)
      if (limits[order]) add_active(joint, j, order, *limits[order], "limit/", active);
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

/// Status and reason, from the attempts in the order of their values.
void judge(const std::vector<TimeAttempt>& attempts, bool cancelled, bool spent,
           SplineTimesOutcome& out) {
  const double value = attempts.front().value;
  out.starts = static_cast<int>(attempts.size());
  out.agreeing = static_cast<int>(std::count_if(
      attempts.begin(), attempts.end(),
      [&](const TimeAttempt& each) { return each.value <= value * (1 + agreement); }));
  out.spread = attempts.size() > 1 ? attempts[1].value / value - 1 : 0;
  const std::string of = " of " + std::to_string(attempts.size()) + " starts";
  const auto answer = [&](OptimizeStatus status, std::string reason) {
    out.status = status;
    out.reason = std::move(reason);
  };
  if (cancelled) return answer(OptimizeStatus::cancelled, "stopped by the caller");
  if (out.agreeing > 1)
    return answer(OptimizeStatus::converged,
                  std::to_string(out.agreeing) + of + " agree to 1e-6, the best two to " +
                      optimize_detail::brief(out.spread) + "; a local search is no proof");
  answer(OptimizeStatus::stalled,
         spent ? "the budget ended after " + std::to_string(attempts.size()) + " starts"
               : "only one" + of + " found this result: more starts may find a better one");
}

/// The starts, until the budget or the caller ends them.
class Starts {
 public:
  Starts(const SplineTimesSpec& spec, const KeepGoing& keep_going)
      : spec_(spec), keep_going_(keep_going), count_(spec.options.starts.value_or(24)) {}

  SplineTimesOutcome run() {
    std::uint64_t state = spec_.options.seed;
    for (int i = 0; i < count_ && (i == 0 || go_on()); ++i) {
      attempts_.push_back(optimize_detail::improve(spec_, start(spec_, i, state)));
      out_.evaluations += attempts_.back().evaluations;
      out_.value = i == 0 ? attempts_.back().value : std::min(out_.value, attempts_.back().value);
    }
    std::stable_sort(attempts_.begin(), attempts_.end(),
                     [](const TimeAttempt& a, const TimeAttempt& b) { return a.value < b.value; });
    SplineTimes& best = out_.best;
    best.intervals = attempts_.front().intervals;
    best.duration = std::accumulate(best.intervals.begin(), best.intervals.end(), 0.0);
    best.joints = spline_through(spec_.points, best.intervals);
    out_.limits = check_all(spec_, best.joints);
    out_.feasible = out_.limits.ok();
    out_.active = active_of(spec_, out_);
    judge(attempts_, cancelled_, spent_, out_);
    return std::move(out_);
  }

 private:
  bool go_on() {
    const auto& [evaluations, seconds] = spec_.options.budget;
    const std::chrono::duration<double> gone = std::chrono::steady_clock::now() - begin_;
    spent_ =
        (evaluations && out_.evaluations >= *evaluations) || (seconds && gone.count() >= *seconds);
    cancelled_ =
        keep_going_ && !keep_going_({.done = static_cast<double>(attempts_.size()) / count_,
                                     .evaluations = out_.evaluations,
                                     .reached = out_.value});
    return !spent_ && !cancelled_;
  }

  const SplineTimesSpec& spec_;
  const KeepGoing& keep_going_;
  int count_;
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
  std::vector<TimeAttempt> attempts_;
  SplineTimesOutcome out_;
  bool cancelled_ = false;
  bool spent_ = false;
};

}  // namespace

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
    const auto s = optimize_detail::joint_spline<double>(positions, intervals);
    std::vector<Segment> segments;
    for (std::size_t i = 0; i < intervals.size(); ++i)
      segments.push_back(
          cubic(intervals[i], s.position[i], s.velocity[i], s.position[i + 1], s.velocity[i + 1]));
    joints.emplace_back(std::move(segments), 0, Extrapolation::hold);
  }
  return joints;
}

SplineTimesOutcome spline_times(const SplineTimesSpec& spec, const KeepGoing& keep_going) {
  require_valid(spec);
  return Starts(spec, keep_going).run();
}

}  // namespace jounce
