#include "jounce/optimize/detail/findings.hpp"

#include <array>
#include <charconv>
#include <cmath>

namespace jounce::optimizer {
namespace {

constexpr double met = 1e-6;  ///< relative: closer than this is there

Finding at(std::string rule, const char* quantity, const Extremum& e, double limit, double margin,
           std::size_t segment) {
  return {std::move(rule), "", quantity, e.where, e.value, limit, margin, false, segment, ""};
}

void add_limits(const Shape& shape, const Space& space, std::span<const Ceiling> ceilings,
                std::vector<Finding>& active) {
  for (std::size_t i = 0; i < shape.ranges.size(); ++i)
    for (const Ceiling& c : ceilings) {
      const double excess = excess_of(c, shape.ranges[i][c.order]);
      if (std::abs(excess) > met) continue;
      const char* quantity = OverMaster::names[c.order];
      const char* end = c.order > 0 ? "" : c.sign > 0 ? "_max" : "_min";
      active.push_back(at(std::string("limit/") + quantity + end, quantity,
                          worst(shape.ranges[i][c.order], c.sign), c.sign * c.limit, -excess,
                          space.pieces[i].segment));
    }
}

void add_bounds(const Space& space, const Point& z, std::vector<Finding>& active) {
  const auto knots = knots_at(space, z);
  for (const Variable& v : space.variables) {
    const std::size_t q = index(v.quantity);
    const Extremum here{knots[v.knot][q], knots[v.knot][0], Side::right};
    for (const double bound : {v.lower, v.upper}) {
      const double margin = std::abs(here.value - bound) / v.scale;
      if (margin <= met)
        active.push_back(at(std::string("bound/") + quantity_names[q],
                            free_key(v.knot, v.quantity).c_str(), here, bound, margin,
                            v.knot > 0 ? v.knot - 1 : 0));
    }
  }
}

void add_peaks(const Shape& shape, const Space& space, const ObjectiveResult& result,
               std::vector<Finding>& active) {
  const auto order = peak_order(result.objective);
  if (!order || result.reached == 0) return;
  for (std::size_t i = 0; i < shape.ranges.size(); ++i)
    for (const Extremum& e : {shape.ranges[i][*order].min, shape.ranges[i][*order].max})
      if (result.reached - std::abs(e.value) <= met * result.reached)
        active.push_back(at(std::string("objective/") + name(result.objective),
                            OverMaster::names[*order], e, std::copysign(result.reached, e.value), 0,
                            space.pieces[i].segment));
}

}  // namespace

std::string brief(double value) {
  std::array<char, 32> text{};
  const auto end =
      std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::general, 6);
  return {text.data(), end.ptr};
}

std::string sentence(const Finding& finding) {
  return finding.quantity + " is " + brief(finding.value) + " at master " + brief(finding.where) +
         ", the limit " + brief(finding.limit);
}

std::string broken_sentence(const Finding& finding) {
  return sentence(finding) + ", passed by " + brief(-finding.margin) + " of it";
}

std::vector<Finding> active_findings(const Space& space, std::span<const Ceiling> ceilings,
                                     const Point& z, std::span<const ObjectiveResult> objectives) {
  const Shape shape(space, z);
  std::vector<Finding> active;
  add_limits(shape, space, ceilings, active);
  add_bounds(space, z, active);
  for (const ObjectiveResult& result : objectives) add_peaks(shape, space, result, active);
  return active;
}

}  // namespace jounce::optimizer
