// SPDX-License-Identifier: Apache-2.0
#include "optimize/src/knots/subproblem.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace jounce::optimize_detail {

std::vector<DerivativeBound> ceilings_of(const Limits& limits, const RampedLimits& ramped,
                                         const Space& space) {
  std::vector<DerivativeBound> all;
  if (limits.position_max) all.push_back({0, 1, *limits.position_max, space.stroke});
  if (limits.position_min) all.push_back({0, -1, -*limits.position_min, space.stroke});
  const std::array rates{limits.velocity, limits.acceleration, limits.jerk};
  for (std::size_t k = 0; k < rates.size(); ++k)
    if (rates[k])
      for (const double sign : {1.0, -1.0}) all.push_back({k + 1, sign, *rates[k], *rates[k]});
  for (const auto& four : ramped_ceilings(ramped)) all.insert(all.end(), four.begin(), four.end());
  return all;
}

std::vector<std::vector<DerivativeBound>> ramped_ceilings(const RampedLimits& ramped) {
  std::vector<std::vector<DerivativeBound>> all;
  const auto add = [&](std::size_t order, const std::optional<double>& limit, double lower) {
    if (!limit || lower == 0) return;
    auto& four = all.emplace_back();
    for (const double sign : {1.0, -1.0})
      for (const double each : {lower, -lower}) four.push_back({order, sign, *limit, *limit, each});
  };
  add(2, ramped.limits.acceleration, ramped.ramp);
  add(3, ramped.limits.jerk, 3 * ramped.ramp);
  return all;
}

Range range_of(const Cam& cam, std::size_t segment, const DerivativeBound& ceiling) {
  if (ceiling.lower == 0) return segment_range(cam, segment, static_cast<int>(ceiling.order));
  Segment below = cam.segments()[segment];
  for (std::size_t k = 1; k < ceiling.order; ++k) below = derivative(below);
  // Always fits: a derivative has the sines of its function.
  const Segment both = *sum(derivative(below), scaled(below, ceiling.lower));
  return segment_range(both, cam.breaks()[segment], cam.breaks()[segment + 1], 0);
}

Shape::Shape(const Space& space, const Point& z) : cam(design(spec_at(space, z)).cam) {
  for (std::size_t i = 0; i < cam.segments().size(); ++i) ranges.push_back(segment_extrema(cam, i));
}

double Shape::place(std::size_t piece, const Extremum& e) const {
  const double s = (e.where - cam.breaks()[piece]) / cam.segments()[piece].length;
  return e.side == Side::left ? 1 : std::clamp(s, 0.0, 1.0);
}

Range Shape::range(std::size_t piece, const DerivativeBound& ceiling) const {
  return ceiling.lower == 0 ? ranges[piece][ceiling.order] : range_of(cam, piece, ceiling);
}

double excess_of(const DerivativeBound& ceiling, const Range& range) {
  return (ceiling.sign * worst(range, ceiling.sign).value - ceiling.limit) / ceiling.scale;
}

std::optional<std::size_t> peak_order(const std::optional<Objective>& objective) {
  if (objective == Objective::peak_acceleration) return 2;
  if (objective == Objective::peak_jerk) return 3;
  return std::nullopt;
}

Merit merit(const Subproblem& subproblem, const Shape& shape) {
  double excess = -std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < shape.ranges.size(); ++i)
    for (const DerivativeBound& ceiling : subproblem.ceilings)
      if (subproblem.space.moves[subproblem.space.pieces[i].segment])
        excess = std::max(excess, excess_of(ceiling, shape.range(i, ceiling)));
  if (subproblem.rms_ceiling)
    excess = std::max(
        excess, value_of(Objective::rms_acceleration, shape.cam) / *subproblem.rms_ceiling - 1);
  return {subproblem.objective ? value_of(*subproblem.objective, shape.cam) : excess, excess};
}

Merit merit(const Subproblem& subproblem, const Point& z) {
  return merit(subproblem, Shape(subproblem.space, z));
}

bool is_better(const Merit& a, const Merit& b) {
  const bool a_holds = a.excess <= rounding_tolerance;
  const bool b_holds = b.excess <= rounding_tolerance;
  if (a_holds != b_holds) return a_holds;
  return a_holds ? a.value < b.value : a.excess < b.excess;
}

double floor_of(const Subproblem& subproblem) {
  double floor = 0;
  const auto order = peak_order(subproblem.objective);
  if (!order) return floor;
  const Shape shape(subproblem.space, Point(subproblem.space.variables.size(), 0.0));
  for (std::size_t i = 0; i < shape.ranges.size(); ++i)
    if (!subproblem.space.moves[subproblem.space.pieces[i].segment])
      floor = std::max(floor, std::abs(shape.ranges[i][*order].peak().value));
  return floor;
}

}  // namespace jounce::optimize_detail
