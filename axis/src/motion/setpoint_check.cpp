// SPDX-License-Identifier: Apache-2.0
#include "axis/src/motion/setpoint_check.hpp"

#include <algorithm>
#include <cmath>

#include "jounce/profiles/detail/tolerances.hpp"
#include "jounce/profiles/moves/move.hpp"
#include "jounce/pvt/detail/knot_rounding.hpp"

#include "axis/src/motion/move_plan.hpp"

namespace jounce {
namespace {

using profiles_detail::rounded_input;
using profiles_detail::rounded_sum;

constexpr double same = 2e-9;  // relative: admit() tolerates half of that

/// Tolerance for equal positions: rounding, and the travel at the limit velocity in 1e-9 ticks.
double slack(double position, const AxisConfig& config, double dt) {
  return rounded_sum * std::abs(position) + rounded_input * *config.limits.velocity * dt;
}

/// admit() tolerates 1e-9 of the stroke of a path, which is at most the range if both ends are set.
double range_slack(double position, const AxisConfig& config) {
  const double low = config.limits.position_min.value_or(position);
  const double high = config.limits.position_max.value_or(position);
  return same * std::max({high - low, std::abs(low), std::abs(high)});
}

double rounding(double from, double to) {
  return rounded_sum * (std::abs(from) + std::abs(to - from));
}

/// The limit of the velocity, with the rounding of knots that admit() tolerates.
double greatest_velocity(const StepAllowance& step, const AxisConfig& config) {
  const double limit = *config.limits.velocity;
  constexpr double excess = pvt_detail::KnotRounding::greatest_excess;
  return std::max(limit, std::min(step.velocity, limit * (1 + excess)));
}

MotionState mirrored(const MotionState& state) {
  return {-state.position, -state.velocity, -state.acceleration};
}

/// An upper bound of the upward distance of any stop with deceleration s and jerk j, from velocity
/// v and acceleration a. It is the product of (1), which the velocity never exceeds, and (2), the
/// sum of the durations of the three phases, which the duration never exceeds.
///
///     (1)  w = max(v, 0) + a^2 / (2 j)            where a > 0
///     (2)  a / j  +  w / s  +  s / j
double most_way(double v, double a, double s, double j) {
  const double rise = std::max(a, 0.0);
  const double w = std::max(v, 0.0) + rise * rise / (2 * j);
  return w * (rise / j + w / s + s / j);
}

/// The upward distance before reversal from velocity v and acceleration a: with the jerk -j until
/// the acceleration is -s, then at that acceleration. (3) is the instant of a reversal before the
/// acceleration is -s:
///
///     (3)  v + a t - j t^2 / 2 = 0
double way_to_turn(double v, double a, double s, double j) {
  if (std::isinf(j)) return v > 0 ? v * v / (2 * s) : 0;
  const double root = a * a + 2 * j * v;
  if (!(root > 0) || (v <= 0 && a <= 0)) return 0;
  const double T = std::max(0.0, (a + s) / j);
  const double t = (a + std::sqrt(root)) / j;  // (3)
  if (t <= T) return std::max(0.0, t * (v + t * (a / 2 - t * j / 6)));
  const double then = v + T * (a - T * j / 2);
  return std::max(0.0, T * (v + T * (a / 2 - T * j / 6)) + then * then / (2 * s));
}

/// The gentlest stop that stays below a position.
Stop gentlest_below(double most, const MotionState& state, const AxisConfig& config) {
  const auto& [p, v, a] = state;
  const double j = config.limits.jerk ? config.stop_jerk : Bounds::none;
  const auto inside = [&, from = p](double furthest) {
    return furthest <= most + rounding(from, furthest);
  };
  if (!inside(p)) return Stop::none;
  if (v <= 0 && (a <= 0 || std::isinf(j))) return Stop::soft;
  const double soft = config.limit_acceleration;
  const double hard = config.stop_acceleration;
  if (inside(p + most_way(v, a, soft, j))) return Stop::soft;
  const auto rests = [&](double deceleration) {
    const MoveResult stop = move_velocity(state, 0, within(Bounds::none, deceleration, j));
    return stop && inside(positions(stop.profile)[1]);
  };
  if (rests(soft)) return Stop::soft;
  if (rests(hard)) return Stop::hard;
  return inside(p + way_to_turn(v, a, hard, j)) ? Stop::turning : Stop::none;
}

}  // namespace

Cause check_setpoint(const MotionState& last, const MotionState& next, const StepAllowance& step,
                     const AxisConfig& config) noexcept {
  const auto& [p, v, a] = next;
  if (!std::isfinite(p) || !std::isfinite(v) || !std::isfinite(a)) return Cause::jump;
  const double most = greatest_velocity(step, config);
  const double way = most * step.dt * (1 + same) + slack(p, config, step.dt);
  if (std::abs(p - last.position) > way) return Cause::overspeed;
  if (std::abs(v) > most * (1 + same)) return Cause::overspeed;
  const double near = range_slack(p, config);
  if (config.limits.position_max && p > *config.limits.position_max + near && p > last.position)
    return Cause::out_of_range;
  if (config.limits.position_min && p < *config.limits.position_min - near && p < last.position)
    return Cause::out_of_range;
  const double change = config.stop_acceleration * step.dt + step.velocity_step;
  const double rounding = rounded_sum * *config.limits.velocity;
  if (std::abs(v - last.velocity) > change * (1 + same) + rounding) return Cause::jump;
  if (std::abs(a) > config.stop_acceleration * (1 + same)) return Cause::jump;
  return Cause::none;
}

Stop gentlest_stop(const MotionState& state, const AxisConfig& config) noexcept {
  const auto& [low, high, v, a, j] = config.limits;
  const double p = state.position;
  const Stop up = high ? gentlest_below(std::max(*high, p), state, config) : Stop::soft;
  const Stop down = low ? gentlest_below(std::max(-*low, -p), mirrored(state), config) : Stop::soft;
  return std::max(up, down);
}

Cause check_range(const MotionState& last, const MotionState& next,
                  const AxisConfig& config) noexcept {
  const auto& [low, high, v, a, j] = config.limits;
  const auto loses = [&](double limit, const MotionState& before, const MotionState& after) {
    const double most = std::max(limit, before.position);  // an axis outside may return
    const Stop left = gentlest_below(most, after, config);
    return left != Stop::soft && left > gentlest_below(most, before, config);
  };
  if (high && loses(*high, last, next)) return Cause::positive_soft_limit;
  if (low && loses(-*low, mirrored(last), mirrored(next))) return Cause::negative_soft_limit;
  return Cause::none;
}

double reached_speed(const MotionState& state, const AxisConfig& config) noexcept {
  const auto& [p, v, a] = state;
  const bool grows = config.limits.jerk && v * a >= 0;
  return std::abs(v) + (grows ? a * a / (2 * config.stop_jerk) : 0);
}

bool exceeds_velocity(const MotionState& state, const AxisConfig& config) noexcept {
  return reached_speed(state, config) > *config.limits.velocity * (1 + same);
}

bool exceeds_acceleration(const MotionState& state, const AxisConfig& config) noexcept {
  return state.velocity * state.acceleration > 0 &&
         std::abs(state.acceleration) > *config.limits.acceleration * (1 + same);
}

bool stays_inside(const Profile& motion, const AxisConfig& config) noexcept {
  const auto& [low, high, v, a, j] = config.limits;
  const auto [least, most] = positions(motion);
  const double from = motion.start().position;
  return (!high || most <= std::max(*high, from) + rounding(from, most)) &&
         (!low || least >= std::min(*low, from) - rounding(from, least));
}

}  // namespace jounce
