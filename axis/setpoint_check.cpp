#include "jounce/axis/setpoint_check.hpp"

#include <algorithm>
#include <cmath>

#include "jounce/profiles/query.hpp"

namespace jounce {
namespace {

constexpr double same = 2e-9;  // relative: admit() forgives half of that

/// What counts as the same position here: rounding, and what the limit velocity does in 1e-9 ticks.
double slack(double position, const AxisConfig& config, double dt) {
  return 1e-12 * std::abs(position) + 1e-9 * *config.limits.velocity * dt;
}

/// admit() forgives a path 1e-9 of its stroke, which is at most the range where both ends are set.
double range_slack(double position, const AxisConfig& config) {
  const double low = config.limits.position_min.value_or(position);
  const double high = config.limits.position_max.value_or(position);
  return same * std::max({high - low, std::abs(low), std::abs(high)});
}

}  // namespace

Cause check_setpoint(const MotionState& last, const MotionState& next, const StepAllowance& step,
                     const AxisConfig& config) noexcept {
  const auto& [p, v, a] = next;
  if (!std::isfinite(p) || !std::isfinite(v) || !std::isfinite(a)) return Cause::jump;
  const double way = *config.limits.velocity * step.dt * (1 + same) + slack(p, config, step.dt);
  if (std::abs(p - last.position) > way) return Cause::overspeed;
  if (std::abs(v) > *config.limits.velocity * (1 + same)) return Cause::overspeed;
  const double near = range_slack(p, config);
  if (config.limits.position_max && p > *config.limits.position_max + near && p > last.position)
    return Cause::out_of_range;
  if (config.limits.position_min && p < *config.limits.position_min - near && p < last.position)
    return Cause::out_of_range;
  const double change = config.stop_acceleration * step.dt + step.velocity_step;
  const double rounding = 1e-12 * *config.limits.velocity;
  if (std::abs(v - last.velocity) > change * (1 + same) + rounding) return Cause::jump;
  if (std::abs(a) > config.stop_acceleration * (1 + same)) return Cause::jump;
  return Cause::none;
}

Cause check_stopping(const MotionState& next, const AxisConfig& config) noexcept {
  const Limits& limits = config.limits;
  if (!limits.position_min && !limits.position_max) return Cause::none;
  const Ramp ramp{config.limit_acceleration, limits.jerk ? config.stop_jerk : Ramp::none};
  const auto stop = stopping({next.velocity, next.acceleration}, ramp);
  if (!stop) return Cause::none;
  const double end = next.position + stop->distance;
  const double near = 1e-12 * (std::abs(next.position) + std::abs(stop->distance));  // rounding
  if (limits.position_max && stop->distance > 0 && end > *limits.position_max + near)
    return Cause::positive_soft_limit;
  if (limits.position_min && stop->distance < 0 && end < *limits.position_min - near)
    return Cause::negative_soft_limit;
  return Cause::none;
}

}  // namespace jounce
