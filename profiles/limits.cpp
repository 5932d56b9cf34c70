#include "jounce/profiles/limits.hpp"

#include <algorithm>
#include <cmath>

#include "jounce/profiles/error.hpp"

namespace jounce {
namespace {

/// One bound on one derivative: the curve must stay on `inner` side of `limit`.
struct Bound {
  std::size_t order;
  std::string rule;
  double limit;
  bool upper;
  double scale;  // what a margin of 1 means
};

std::vector<Bound> bounds_of(const Limits& limits, const std::array<const char*, 4>& names,
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
    const std::string rule = std::string("limit/") + names[k + 1];
    bounds.push_back({k + 1, rule, *rates[k], true, *rates[k]});
    bounds.push_back({k + 1, rule, -*rates[k], false, *rates[k]});
  }
  return bounds;
}

const char* advice(std::size_t order) {
  constexpr std::array texts{
      "the curve overshoots between its knots: move them, or lower the velocities there",
      "lengthen the segment, or take a law with a lower velocity coefficient",
      "lengthen the segment, or take a law with a lower acceleration coefficient",
      "lengthen the segment, or take a law with a lower jerk coefficient"};
  return texts[order];
}

const Extremum& worst_of(const Bound& bound, const Range& range) {
  return bound.upper ? range.max : range.min;
}

double margin_of(const Bound& bound, double value) {
  return (bound.upper ? bound.limit - value : value - bound.limit) / bound.scale;
}

/// A limit that is met exactly is met: what is left is the rounding of the evaluation.
bool is_broken(const Bound& bound, double value) {
  const double room = bound.upper ? bound.limit - value : value - bound.limit;
  return room < -1e-12 * std::max({std::abs(bound.limit), std::abs(value), bound.scale});
}

Finding finding_of(const Bound& bound, const Extremum& worst, const char* quantity,
                   std::size_t segment) {
  const bool broken = is_broken(bound, worst.value);
  return {bound.rule,
          "",
          quantity,
          worst.where,
          worst.value,
          bound.limit,
          margin_of(bound, worst.value),
          broken,
          segment,
          broken ? advice(bound.order) : ""};
}

/// A peak on a break belongs to both segments beside it: told of the first.
bool is_told(const std::optional<Finding>& before, const Extremum& worst, double start) {
  return before && worst.where == start && before->where == start &&
         std::abs(worst.value - before->value) <= 1e-12 * std::abs(worst.value);
}

}  // namespace

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

template <class Over>
Report check(const Curve<Over>& f, const Limits& limits) {
  require_valid(limits);
  const bool one_end = limits.position_min.has_value() != limits.position_max.has_value();
  const Range travel = one_end ? extrema(f, 0) : Range{};
  const auto bounds = bounds_of(limits, Over::names, travel.max.value - travel.min.value);
  std::vector<std::optional<Finding>> closest(bounds.size());
  std::vector<std::optional<Finding>> broken(bounds.size());  // the last of each
  Report report;
  for (std::size_t i = 0; i < f.segments().size(); ++i) {
    Range range;
    for (std::size_t b = 0; b < bounds.size(); ++b) {
      const auto order = bounds[b].order;
      if (b == 0 || order != bounds[b - 1].order)
        range = segment_range(f, i, static_cast<int>(order));
      const Extremum& worst = worst_of(bounds[b], range);
      if (is_broken(bounds[b], worst.value)) {
        if (is_told(broken[b], worst, f.breaks()[i])) continue;
        broken[b] = finding_of(bounds[b], worst, Over::names[order], i);
        report.findings.push_back(*broken[b]);
      } else if (!closest[b] || margin_of(bounds[b], worst.value) < closest[b]->margin) {
        closest[b] = finding_of(bounds[b], worst, Over::names[order], i);
      }
    }
  }
  // Per rule, the smallest margin; not where the rule is broken somewhere, and of +-limit one.
  for (const auto& candidate : closest) {
    if (!candidate) continue;
    const auto same =
        std::find_if(report.findings.begin(), report.findings.end(),
                     [&](const Finding& other) { return other.rule == candidate->rule; });
    if (same == report.findings.end())
      report.findings.push_back(*candidate);
    else if (!same->broken && candidate->margin < same->margin)
      *same = *candidate;
  }
  sort(report);
  return report;
}

template <class Over>
Report check_continuity(const Curve<Over>& f, int order, double tolerance) {
  const Ranges ranges = extrema(f);
  Report report;
  for (int k = 0; k <= order; ++k) {
    const auto& range = ranges[static_cast<std::size_t>(k)];
    const char* name = Over::names[static_cast<std::size_t>(k)];
    const double scale = k == 0 ? range.max.value - range.min.value : std::abs(range.peak().value);
    // Below the rounding of the values themselves nothing can be called a step.
    const double limit = std::max(tolerance * scale, 1e-14 * std::abs(range.peak().value));
    const Jump jump = largest_jump(f, k);
    const double step = std::abs(jump.step);
    const double margin = limit > 0 ? (limit - step) / limit : -step;
    report.findings.push_back({std::string("continuity/") + name, "",
                               std::string("step of ") + name, jump.where, step, limit, margin,
                               step > limit, std::nullopt,
                               step > limit ? "make both sides of the joint agree" : ""});
  }
  sort(report);
  return report;
}

#define JOUNCE_INSTANTIATE(Over)                            \
  template Report check(const Curve<Over>&, const Limits&); \
  template Report check_continuity(const Curve<Over>&, int, double);
JOUNCE_INSTANTIATE(OverTime)
JOUNCE_INSTANTIATE(OverMaster)
#undef JOUNCE_INSTANTIATE

}  // namespace jounce
