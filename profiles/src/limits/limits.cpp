// SPDX-License-Identifier: Apache-2.0
#include "jounce/profiles/limits/limits.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "jounce/profiles/curve/over_length.hpp"
#include "jounce/profiles/detail/derivative_order.hpp"
#include "jounce/profiles/detail/limit_check.hpp"
#include "jounce/profiles/detail/tolerances.hpp"
#include "jounce/profiles/error.hpp"
#include "jounce/profiles/moves/move.hpp"

namespace jounce {
namespace {

using profiles_detail::Bound;
using profiles_detail::rounded_sum;
using profiles_detail::rounded_value;

/// Share of a segment: a smooth peak that is so close to its end has the value of the end.
constexpr double beside_end = 1e-6;

std::vector<Bound> signed_limits(const Limits& limits, const std::array<const char*, 4>& names,
                                 double stroke) {
  std::vector<Bound> bounds;
  const bool both = limits.position_min && limits.position_max;
  const double travel = both ? *limits.position_max - *limits.position_min : stroke;
  const double scale = travel > 0 ? travel : 1;
  if (limits.position_min)
    bounds.push_back({0, "limit/position_min", *limits.position_min, false, scale});
  if (limits.position_max)
    bounds.push_back({0, "limit/position_max", *limits.position_max, true, scale});
  const std::array rates{limits.velocity, limits.acceleration, limits.jerk};
  for (std::size_t k = 0; k < rates.size(); ++k) {
    if (!rates[k]) continue;
    const Rule rule(RuleFamily::limit, names[k + 1]);
    bounds.push_back({k + 1, rule, *rates[k], true, *rates[k]});
    bounds.push_back({k + 1, rule, -*rates[k], false, *rates[k]});
  }
  return bounds;
}

/// The advice for a limit that a segment breaks. `at_end`: at one of its ends, which are knots.
const char* advice(const char* quantity, std::size_t order, bool at_end) {
  constexpr std::array of_cams{
      "the curve overshoots between its knots: move the knots, or lower their velocities",
      "lengthen the segment, or use a law with a lower velocity coefficient",
      "lengthen the segment, or use a law with a lower acceleration coefficient",
      "lengthen the segment, or use a law with a lower jerk coefficient"};
  constexpr std::array of_motions{
      "move the target or the points into the position range, or lower the velocities of the "
      "points "
      "next to this place",
      "lower the velocity of the motion, or give the motion more time",
      "lower the acceleration of the motion, or give the motion more time",
      "lower the jerk of the motion, or give the motion more time"};
  const bool over_time = std::find(OverTime::names.begin() + 1, OverTime::names.end(),
                                   std::string_view(quantity)) != OverTime::names.end();
  if (order == 0 && at_end && !over_time)
    return "the knots here are outside the position range: move them, or widen the range";
  return over_time ? of_motions[order] : of_cams[order];
}

const Extremum& worst_of(const Bound& bound, const Range& range) {
  return bound.upper ? range.max : range.min;
}

double margin_of(const Bound& bound, double value) {
  return (bound.upper ? bound.limit - value : value - bound.limit) / bound.scale;
}

/// True if the value exceeds the bound. A value exactly at the limit does not; a smaller excess is
/// rounding of the evaluation.
bool is_broken(const Bound& bound, double value) {
  const double room = bound.upper ? bound.limit - value : value - bound.limit;
  return room < -profiles_detail::forgiven *
                    std::max({std::abs(bound.limit), std::abs(value), bound.scale});
}

/// The advice for a step of the position from the end of a period to the start of the next.
std::string advice_for_gain(double gain, bool over_time) {
  const std::string closed = "the motion repeats: let it end at its first position";
  if (over_time)
    return closed + ", or, if it continues from its last position, set outside = \"advance\"";
  if (gain <= 0) return closed;
  return closed +
         ", or, if it advances by this distance in each period, set slave_period = " + number(gain);
}

/// The advice for a step of the derivative of order k at a place.
std::string advice_at(const profiles_detail::Ends& extent, double where, double step,
                      const std::array<const char*, 4>& names, std::size_t k) {
  if (where == extent.end && extent.repeats)
    return k == 0 ? advice_for_gain(-step, std::string_view(names[1]) == OverTime::names[1])
                  : std::string("the motion repeats: let it end with the ") + names[k] +
                        " with which it begins";
  constexpr std::array ends{"", "the motion stops here: let it end at velocity 0",
                            "the motion stops here: let it end at acceleration 0",
                            "the motion stops here: let it end at jerk 0"};
  constexpr std::array starts{"", "the motion starts here: let it begin at velocity 0",
                              "the motion starts here: let it begin at acceleration 0",
                              "the motion starts here: let it begin at jerk 0"};
  if (where == extent.end) return ends[k];
  if (where == extent.start) return starts[k];
  return k == 3 ? "use a law or a table rule whose jerk is continuous"
                : std::string("let both segments have the same ") + names[k] + " here";
}

/// A peak at a break belongs to both adjacent segments; the finding names the first.
bool is_told(const std::optional<Finding>& before, const Extremum& worst, double start) {
  return before && worst.where == start && before->where == start &&
         std::abs(worst.value - before->value) <= rounded_sum * std::abs(worst.value);
}

}  // namespace

Bounds bounds_of(const Limits& limits) {
  Bounds bounds =
      within(limits.velocity.value_or(Bounds::none), limits.acceleration.value_or(Bounds::none),
             limits.jerk.value_or(Bounds::none));
  bounds.position_min = limits.position_min.value_or(-Bounds::none);
  bounds.position_max = limits.position_max.value_or(Bounds::none);
  return bounds;
}

Limits limits_of(const Bounds& bounds) {
  const auto finite = [](double x) { return std::isfinite(x) ? std::optional(x) : std::nullopt; };
  const auto magnitude = [&](double min, double max, const char* key) {
    if (min != -max)
      throw InputError(key, min, "must be minus the maximum: limits of a check have one magnitude");
    return finite(max);
  };
  const Limits limits{
      finite(bounds.position_min), finite(bounds.position_max),
      magnitude(bounds.velocity_min, bounds.velocity_max, "velocity_min"),
      magnitude(bounds.acceleration_min, bounds.acceleration_max, "acceleration_min"),
      magnitude(bounds.jerk_min, bounds.jerk_max, "jerk_min")};
  require_valid(limits);
  return limits;
}

void require_valid(const Limits& limits) {
  if (limits.position_min) require_finite("position_min", *limits.position_min);
  if (limits.position_max) require_finite("position_max", *limits.position_max);
  if (limits.position_min && limits.position_max && *limits.position_min > *limits.position_max)
    throw InputError("position_min", *limits.position_min,
                     "must not be above position_max = " + number(*limits.position_max));
  if (limits.velocity) require_positive("velocity", *limits.velocity);
  if (limits.acceleration) require_positive("acceleration", *limits.acceleration);
  if (limits.jerk) require_positive("jerk", *limits.jerk);
}

bool Report::ok() const {
  return broken() == 0;
}

std::size_t Report::broken() const {
  return static_cast<std::size_t>(
      std::count_if(findings.begin(), findings.end(), [](const Finding& f) { return f.broken; }));
}

std::size_t Report::warnings() const {
  return static_cast<std::size_t>(
      std::count_if(findings.begin(), findings.end(),
                    [](const Finding& f) { return !f.broken && f.severity == Severity::warning; }));
}

void sort(Report& report) {
  const auto rank = [](const Finding& f) {
    if (f.broken) return 0;
    if (f.severity == Severity::warning) return 1;
    return f.severity == Severity::required ? 2 : 3;
  };
  std::stable_sort(report.findings.begin(), report.findings.end(),
                   [&](const Finding& a, const Finding& b) {
                     return rank(a) != rank(b) ? rank(a) < rank(b) : a.margin < b.margin;
                   });
}

namespace profiles_detail {

double room_of(const Bound& bound, const Range& range) {
  return margin_of(bound, worst_of(bound, range).value);
}

LimitCheck::LimitCheck(const Limits& limits, const std::array<const char*, 4>& names, double stroke)
    : names_(names),
      bounds_(signed_limits(limits, names, stroke)),
      closest_(bounds_.size()),
      broken_(bounds_.size()) {}

Finding LimitCheck::finding_of(const Bound& bound, const Extremum& worst, std::size_t segment,
                               bool at_end) const {
  const bool broken = is_broken(bound, worst.value);
  return {bound.rule,
          "",
          names_[bound.order],
          worst.where,
          worst.value,
          bound.limit,
          margin_of(bound, worst.value),
          broken,
          segment,
          broken ? advice(names_[1], bound.order, at_end) : ""};
}

void LimitCheck::consider(std::size_t b, const Range& range, double start, double end,
                          std::size_t segment) {
  const Bound& bound = bounds_[b];
  const Extremum& worst = worst_of(bound, range);
  const double near = beside_end * (end - start);
  const bool at_end = worst.where <= start + near || worst.where >= end - near;
  if (is_broken(bound, worst.value)) {
    if (is_told(broken_[b], worst, start)) return;
    broken_[b] = finding_of(bound, worst, segment, at_end);
    report_.findings.push_back(*broken_[b]);
  } else if (!closest_[b] || margin_of(bound, worst.value) < closest_[b]->margin) {
    closest_[b] = finding_of(bound, worst, segment, at_end);
  }
}

std::optional<double> LimitCheck::closest(std::size_t bound) const {
  return closest_[bound] ? std::optional(closest_[bound]->value) : std::nullopt;
}

Report LimitCheck::report() && {
  // Keeps the smallest margin for each rule, unless the rule is broken; +limit and -limit are one
  // rule.
  for (const auto& candidate : closest_) {
    if (!candidate) continue;
    const auto same =
        std::find_if(report_.findings.begin(), report_.findings.end(),
                     [&](const Finding& other) { return other.rule == candidate->rule; });
    if (same == report_.findings.end())
      report_.findings.push_back(*candidate);
    else if (!same->broken && candidate->margin < same->margin)
      *same = *candidate;
  }
  sort(report_);
  return std::move(report_);
}

Report continuity_report(const Ranges& ranges, const std::array<Jump, 4>& jumps,
                         const std::array<const char*, 4>& names, const Ends& extent, int order,
                         double tolerance) {
  Report report;
  for (std::size_t k = 0; k <= static_cast<std::size_t>(order); ++k) {
    const auto& range = ranges[k];
    const double scale = k == 0 ? range.max.value - range.min.value : std::abs(range.peak().value);
    // A step below the rounding of the values cannot be detected.
    const double limit = std::max(tolerance * scale, rounded_value * std::abs(range.peak().value));
    const double step = std::abs(jumps[k].step);
    const double margin = limit > 0 ? (limit - step) / limit : -step;
    report.findings.push_back(
        {Rule(RuleFamily::continuity, names[k]), "", std::string("step of ") + names[k],
         jumps[k].where, step, limit, margin, step > limit, std::nullopt,
         step > limit ? advice_at(extent, jumps[k].where, jumps[k].step, names, k)
                      : std::string()});
  }
  sort(report);
  return report;
}

}  // namespace profiles_detail

template <class Over>
Report check(const Curve<Over>& f, const Limits& limits) {
  require_valid(limits);
  const Range travel = profiles_detail::LimitCheck::needs_stroke(limits) ? extrema(f, 0) : Range{};
  profiles_detail::LimitCheck found(limits, Over::names, travel.max.value - travel.min.value);
  const auto& bounds = found.bounds();
  for (std::size_t i = 0; i < f.segments().size(); ++i) {
    Range range;
    for (std::size_t b = 0; b < bounds.size(); ++b) {
      if (b == 0 || bounds[b].order != bounds[b - 1].order)
        range = segment_range(f, i, static_cast<int>(bounds[b].order));
      found.consider(b, range, f.breaks()[i], f.breaks()[i + 1], i);
    }
  }
  return std::move(found).report();
}

template <class Over>
Report check_continuity(const Curve<Over>& f, int order, double tolerance) {
  profiles_detail::require_order(order);
  std::array<Jump, 4> jumps;
  for (int k = 0; k <= order; ++k) jumps[static_cast<std::size_t>(k)] = largest_jump(f, k);
  return profiles_detail::continuity_report(
      extrema(f), jumps, Over::names, {f.start(), f.end(), repeats(f.outside())}, order, tolerance);
}

#define JOUNCE_INSTANTIATE(Over)                            \
  template Report check(const Curve<Over>&, const Limits&); \
  template Report check_continuity(const Curve<Over>&, int, double);
JOUNCE_INSTANTIATE(OverTime)
JOUNCE_INSTANTIATE(OverMaster)
JOUNCE_INSTANTIATE(OverLength)
#undef JOUNCE_INSTANTIATE

}  // namespace jounce
