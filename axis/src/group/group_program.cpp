// SPDX-License-Identifier: Apache-2.0
#include "jounce/axis/group_program.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

#include "jounce/profiles/curve/extrema.hpp"
#include "jounce/profiles/detail/evaluate.hpp"
#include "jounce/profiles/detail/tolerances.hpp"
#include "jounce/profiles/error.hpp"

#include "axis/src/motion/largest_sum.hpp"

namespace jounce {
namespace {

constexpr double admitted_excess = 1e-9;  ///< relative, as for a table
/// The limits of the MotionAxis of a group exceed those of its axes by this factor: they never bind.
constexpr double not_binding = 1000;

/// Throws if |value| exceeds the limit. `key`: "x.velocity".
void require_within(const std::string& key, double value, const std::optional<double>& limit,
                    const char* unit) {
  if (!limit || std::abs(value) <= *limit * (1 + admitted_excess)) return;
  throw InputError(
      key, std::abs(value),
      "exceeds " + number(*limit) + unit + ", the limit of the axis: lower the limits of the path");
}

void require_inside(const std::string& name, const Range& position, const Limits& limits) {
  const double near = admitted_excess * (position.max.value - position.min.value);
  if (limits.position_max && position.max.value > *limits.position_max + near)
    throw InputError(
        name + ".position", position.max.value,
        "exceeds position_max of the axis, " + number(*limits.position_max) + ": shift the path");
  if (limits.position_min && position.min.value < *limits.position_min - near)
    throw InputError(name + ".position", position.min.value,
                     "is less than position_min of the axis, " + number(*limits.position_min) +
                         ": shift the path");
}

/// The largest sum of the steps of a derivative within one tick, from rest to rest.
Jump largest_step_of(const Trajectory& motion, std::size_t order, double tick) {
  const auto pieces = motion.segments();
  std::vector<Jump> steps;
  double before = 0;
  for (std::size_t i = 0; i <= pieces.size(); ++i) {
    const double after = i < pieces.size() ? evaluate(pieces[i], 0)[order] : 0;
    if (after != before) steps.push_back({after - before, motion.breaks()[i]});
    if (i < pieces.size()) before = evaluate(pieces[i], 1)[order];
  }
  return largest_sum(steps, tick);
}

/// A step of the velocity counts as the acceleration that makes it in one tick, and a step of the
/// acceleration as such a jerk, as in a table.
void require_smooth(const std::string& name, const Trajectory& motion, const AxisConfig& config) {
  const double tick = seconds(config.period);
  const Jump position = largest_jump(motion, 0);
  const double rounding = profiles_detail::rounded_input * *config.limits.velocity;
  if (std::abs(position.step) > rounding * tick)
    throw InputError(name + ".position", position.step,
                     "is a step at " + number(position.where) + " s: the path must have none");
  const Jump velocity = largest_step_of(motion, 1, tick);
  const double most = *config.limits.acceleration * tick + rounding;
  if (std::abs(velocity.step) > most)
    throw InputError(name + ".velocity", velocity.step,
                     "is a step at " + number(velocity.where) + " s, and must be at most " +
                         number(most) + ": the acceleration limit times one cycle");
  if (!config.limits.jerk) return;
  const Jump acceleration = largest_step_of(motion, 2, tick);
  const double most_acceleration = *config.limits.jerk * tick;
  if (std::abs(acceleration.step) > most_acceleration * (1 + admitted_excess))
    throw InputError(name + ".acceleration", acceleration.step,
                     "is a step at " + number(acceleration.where) + " s, and must be at most " +
                         number(most_acceleration) +
                         ": the jerk limit times one cycle. Give the path a jerk limit, and round "
                         "its corners: the curvature steps between a line and an arc");
}

std::optional<double> lower(const std::optional<double>& a, const std::optional<double>& b) {
  return a && b ? std::min(*a, *b) : a ? a : b;
}

double norm(std::span<const AxisConfig> axes, double (*of)(const AxisConfig&)) {
  double sum = 0;
  for (const AxisConfig& axis : axes) sum += of(axis) * of(axis);
  return std::sqrt(sum);
}

}  // namespace

GroupProgram group_program(std::shared_ptr<const Plan> plan, std::span<const AxisConfig> axes,
                           std::span<const std::string> names) {
  if (plan->path().axes() != axes.size())
    throw InputError(
        "axes", std::to_string(axes.size()),
        "must be " + std::to_string(plan->path().axes()) + ", the number of axes of the path");
  GroupProgram program{.plan = std::move(plan), .axes = {}};
  const PlanAxes motions = to_axes(*program.plan);
  for (std::size_t k = 0; k < axes.size(); ++k) {
    const AxisConfig config = resolved(axes[k]);
    const Ranges ranges = extrema(motions.curves[k]);
    std::array<double, 4> peak{};
    for (std::size_t i = 1; i < peak.size(); ++i) peak[i] = std::abs(ranges[i].peak().value);
    require_smooth(names[k], motions.curves[k], config);
    require_inside(names[k], ranges[0], config.limits);
    require_within(names[k] + ".velocity", peak[1], config.limits.velocity, " u/s");
    require_within(names[k] + ".acceleration", peak[2], config.limits.acceleration, " u/s^2");
    require_within(names[k] + ".jerk", peak[3], config.limits.jerk, " u/s^3");
    const Jet& fit = motions.error[k];  // error of arcs, which have a greater reserve
    program.axes.push_back({config,
                            {.velocity = peak[1] + fit[1],
                             .acceleration = peak[2] + fit[2],
                             .jerk = peak[3] + fit[3]}});
  }
  return program;
}

GroupLimits within(const GroupLimits& limits, std::span<const AxisConfig> axes) {
  if (limits.axes.size() != axes.size())
    throw InputError(
        "axes", std::to_string(limits.axes.size()),
        "must be " + std::to_string(axes.size()) + ", the number of axes of the group");
  GroupLimits all = limits;
  for (std::size_t k = 0; k < axes.size(); ++k) {
    const Limits& axis = axes[k].limits;
    Limits& one = all.axes[k];
    one = {.velocity = lower(one.velocity, axis.velocity),
           .acceleration = lower(one.acceleration, axis.acceleration),
           .jerk = lower(one.jerk, axis.jerk)};
  }
  return all;
}

void require_order(std::span<const std::string> path, std::span<const std::string> group) {
  const auto known = [&](const std::string& name) {
    return std::find(group.begin(), group.end(), name) != group.end();
  };
  if (!std::all_of(path.begin(), path.end(), known)) return;
  for (std::size_t k = 0; k < path.size() && k < group.size(); ++k)
    if (path[k] != group[k])
      throw InputError("axes", group[k],
                       "is axis " + std::to_string(k + 1) + " of the group, but " + path[k] +
                           " is that of the path: use the same order");
}

AxisConfig group_config(std::span<const AxisConfig> axes) {
  if (axes.empty()) throw InputError("axes", "", "are missing: a group needs at least one axis");
  AxisConfig group{.period = axes.front().period, .longest_gap = axes.front().longest_gap};
  group.limits.velocity =
      not_binding * norm(axes, [](const AxisConfig& a) { return *a.limits.velocity; });
  group.limits.acceleration =
      not_binding * norm(axes, [](const AxisConfig& a) { return *a.limits.acceleration; });
  return group;
}

}  // namespace jounce
