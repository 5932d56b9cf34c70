// SPDX-License-Identifier: Apache-2.0
#include "executor/src/group/group_dynamics.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>

#include "jounce/profiles/detail/tolerances.hpp"
#include "jounce/profiles/error.hpp"

namespace jounce {
namespace {

std::optional<double> given(double value) {
  return std::isnan(value) ? std::nullopt : std::optional(value);
}

double or_none(double value) {
  return std::isnan(value) ? PathLimits::none : value;
}

/// A plan may exceed its limits by rounding (group_program()).
constexpr double planned_excess = 2 * profiles_detail::rounded_input;

/// Lowers the rate until a peak of this derivative is within the limit: at the rate r, the peak is
/// peak r^order.
void lower_rate(double& rate, double limit, double peak, int order) {
  if (!(peak > 0) || !std::isfinite(limit)) return;
  const double share = limit / peak;
  const double most = order == 1 ? share : order == 2 ? std::sqrt(share) : std::cbrt(share);
  rate = std::min(rate, share < 1 && share > 1 - planned_excess ? 1.0 : most);
}

}  // namespace

GroupDynamics::GroupDynamics(const ExecutorGroup& group) : group_(group) {
  clear();
}

void GroupDynamics::clear() {
  planned_ = {.axes = std::vector<Limits>(group_.configs.size())};
  begin();
  limits_ = false;
}

void GroupDynamics::set(const command::Override& override) {
  override_.velocity = override.factor;
}

void GroupDynamics::set(const command::GroupSetOverride& override) {
  override_ = override;
}

void GroupDynamics::set(const command::GroupSetLimits& limits, bool continues) {
  const auto& [velocity, acceleration, deceleration, jerk] = limits.dynamics;
  const std::size_t axes = group_.configs.size();
  if (limits.axis < 0 || static_cast<std::size_t>(limits.axis) > axes)
    throw InputError(
        "axis", std::to_string(limits.axis),
        "must be from 1 to " + std::to_string(axes) + ", the number of axes of the group");
  if (limits.axis > 0 && !std::isnan(deceleration))
    throw InputError("deceleration", deceleration,
                     "applies along the path only: an axis has one limit of the acceleration");
  if (limits.axis == 0) {
    planned_.path = {.velocity = or_none(velocity),
                     .acceleration = or_none(acceleration),
                     .deceleration = or_none(deceleration),
                     .jerk = or_none(jerk)};
    if (!limits.queued) present_.path = at_once_.path = planned_.path;
  } else {
    const auto k = static_cast<std::size_t>(limits.axis) - 1;
    planned_.axes[k] = {
        .velocity = given(velocity), .acceleration = given(acceleration), .jerk = given(jerk)};
    if (!limits.queued) present_.axes[k] = at_once_.axes[k] = planned_.axes[k];
  }
  continued_ = continued_ || (limits.queued && continues);
  limits_ = true;
}

Limits GroupDynamics::effective(const Limits& configured, const Limits& further) const {
  Limits limits = configured;
  const auto lower = [](std::optional<double>& limit, const std::optional<double>& more,
                        double factor) {
    if (more) limit = limit ? std::min(*limit, *more) : *more;
    if (limit) *limit *= factor;
  };
  lower(limits.velocity, further.velocity, 1);
  lower(limits.acceleration, further.acceleration, override_.acceleration);
  lower(limits.jerk, further.jerk, override_.jerk);
  return limits;
}

/// The group with the shares of the override; `further`: also within the further limits.
ExecutorGroup GroupDynamics::limited(bool further) const {
  ExecutorGroup group = group_;
  for (std::size_t k = 0; k < group.configs.size(); ++k) {
    group.configs[k] = resolved(group.configs[k]);  // the stop limits stay
    const Limits by = further ? planned_.axes[k] : Limits{};
    Limits& axis = group.configs[k].limits;
    axis = effective(axis, by);
    group.configs[k].homing = {};  // its values may exceed these limits
    if (!group.kinematics) continue;
    Limits& joint = group.kinematics->joints.limits[k];
    joint = effective(joint, by);
  }
  return group;
}

/// The further limits for PathSettings::axes; empty: none.
std::vector<AxisRates> GroupDynamics::further_rates() const {
  const std::size_t first = group_.kinematics ? group_.kinematics->names.size() : 0;
  std::vector<AxisRates> rates(first);
  for (const Limits& further : planned_.axes) {
    const Limits limits = effective({}, further);
    rates.push_back({limits.velocity.value_or(AxisRates::none),
                     limits.acceleration.value_or(AxisRates::none),
                     limits.jerk.value_or(AxisRates::none)});
  }
  while (!rates.empty() && rates.back() == AxisRates{}) rates.pop_back();
  return rates;
}

GroupDynamics::Next GroupDynamics::next() const {
  return {limited(false), limited(true), planned_.path, further_rates()};
}

double GroupDynamics::rate(const GroupProgram& program, double length) const {
  const ProgramPart& part = part_at(program, length);
  if (!continued_) return within(override_.velocity, part, present_);
  // The commands are planned with the shares of the override at that time. Shares that are lower now
  // also apply to their further limits.
  double rate = std::min(override_.velocity, 1.0);
  const Limits& configured = group_.configs.front().limits;
  const Limits& planned = program.axes.front().config.limits;
  lower_rate(rate, override_.acceleration * *configured.acceleration, *planned.acceleration, 2);
  if (planned.jerk) lower_rate(rate, override_.jerk * *configured.jerk, *planned.jerk, 3);
  return within(rate, part, at_once_);
}

/// The rate, lowered until the peaks of a part are within the limits.
double GroupDynamics::within(double rate, const ProgramPart& part,
                             const GroupLimits& limits_of) const {
  for (std::size_t k = 0; k < part.axes.size() && k < group_.configs.size(); ++k) {
    const Peaks& peaks = part.axes[k];
    const Limits& further = limits_of.axes[k];
    const Limits limits = effective(group_.configs[k].limits, further);
    if (further.velocity) lower_rate(rate, *limits.velocity, peaks.velocity, 1);
    if (further.acceleration || override_.acceleration < 1)
      lower_rate(rate, *limits.acceleration, peaks.acceleration, 2);
    if (limits.jerk && (further.jerk || override_.jerk < 1))
      lower_rate(rate, *limits.jerk, peaks.jerk, 3);
  }
  lower_rate(rate, limits_of.path.velocity, part.along.velocity, 1);
  lower_rate(rate, std::min(limits_of.path.acceleration, limits_of.path.deceleration),
             part.along.acceleration, 2);
  lower_rate(rate, limits_of.path.jerk, part.along.jerk, 3);
  return rate;
}

}  // namespace jounce
