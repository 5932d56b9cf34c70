// SPDX-License-Identifier: Apache-2.0
#include "optimize/src/search/findings.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <optional>

namespace jounce::optimize_detail {
namespace {

/// The quantity of a ceiling, and its rule.
std::string derivative_name(const DerivativeBound& ceiling) {
  const std::string name = OverMaster::names[ceiling.order];
  return ceiling.lower == 0 ? name : name + " while the master accelerates";
}

std::string rule_of(const DerivativeBound& ceiling) {
  const char* end = ceiling.order > 0 ? "" : ceiling.sign > 0 ? "_max" : "_min";
  return std::string(ceiling.lower == 0 ? "limit/" : "limit/ramped_") +
         OverMaster::names[ceiling.order] + end;
}

Finding at(Rule rule, const std::string& quantity, const Extremum& e, double limit, double margin,
           std::size_t segment) {
  return {std::move(rule), "", quantity, e.where, e.value, limit, margin, false, segment, ""};
}

void add_limits(const Shape& shape, const Space& space, std::span<const DerivativeBound> ceilings,
                std::vector<Finding>& active) {
  for (std::size_t i = 0; i < shape.ranges.size(); ++i)
    for (const DerivativeBound& c : ceilings) {
      const Range range = shape.range(i, c);
      const double excess = excess_of(c, range);
      if (std::abs(excess) > active_tolerance) continue;
      active.push_back(at(rule_of(c), derivative_name(c), worst(range, c.sign), c.sign * c.limit,
                          -excess, space.pieces[i].segment));
    }
}

void add_bounds(const Space& space, const Point& z, std::vector<Finding>& active) {
  const auto knots = knots_at(space, z);
  for (const Variable& v : space.variables) {
    const std::size_t q = index(v.quantity);
    const Extremum here{knots[v.knot][q], knots[v.knot][0], Side::right};
    for (const double bound : {v.lower, v.upper}) {
      const double margin = std::abs(here.value - bound) / v.scale;
      if (margin <= active_tolerance)
        active.push_back(at(std::string("bound/") + quantity_names[q], free_key(v.knot, v.quantity),
                            here, bound, margin, v.knot > 0 ? v.knot - 1 : 0));
    }
  }
}

void add_peaks(const Shape& shape, const Space& space, Objective objective,
               const FigureResult& result, std::vector<Finding>& active) {
  const auto order = peak_order(objective);
  if (!order || result.reached == 0) return;
  for (std::size_t i = 0; i < shape.ranges.size(); ++i)
    for (const Extremum& e : {shape.ranges[i][*order].min, shape.ranges[i][*order].max})
      if (result.reached - std::abs(e.value) <= active_tolerance * result.reached)
        active.push_back(at("objective/" + result.name, OverMaster::names[*order], e,
                            std::copysign(result.reached, e.value), 0, space.pieces[i].segment));
}

}  // namespace

std::string brief(double value, int digits) {
  std::array<char, 32> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value,
                                 std::chars_format::general, digits);
  return {text.data(), end.ptr};
}

std::string sentence(const Finding& finding) {
  return finding.quantity + " is " + brief(finding.value) + " at master " + brief(finding.where) +
         ", the limit " + brief(finding.limit);
}

std::string broken_sentence(const Finding& finding) {
  const double share = -finding.margin;
  return sentence(finding) + (share < 10 ? ": exceeded by " + brief(100 * share) + " %"
                                         : ": exceeded " + brief(1 + share) + " times");
}

Report limits_of(const Limits& limits, const RampedLimits& ramped, const Cam& cam) {
  Report report = check(cam, limits);
  for (const auto& four : ramped_ceilings(ramped)) {
    std::optional<Finding> least;
    for (const DerivativeBound& c : four)
      for (std::size_t i = 0; i < cam.segments().size(); ++i) {
        const Range range = range_of(cam, i, c);
        const double excess = excess_of(c, range);
        if (least && least->margin <= -excess) continue;
        least =
            at(rule_of(c), derivative_name(c), worst(range, c.sign), c.sign * c.limit, -excess, i);
        least->broken = excess > rounding_tolerance;
      }
    if (least) report.findings.push_back(*std::move(least));
  }
  sort(report);
  return report;
}

std::vector<Finding> active_findings(const Space& space, std::span<const DerivativeBound> ceilings,
                                     const Point& z, std::span<const Objective> minimize,
                                     std::span<const FigureResult> figures) {
  const Shape shape(space, z);
  std::vector<Finding> active;
  add_limits(shape, space, ceilings, active);
  add_bounds(space, z, active);
  for (std::size_t k = 0; k < minimize.size(); ++k)
    add_peaks(shape, space, minimize[k], figures[k], active);
  return active;
}

}  // namespace jounce::optimize_detail
