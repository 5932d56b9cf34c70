// SPDX-License-Identifier: Apache-2.0
#include "axis/src/motion/superimposed_move.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace jounce {
namespace {

/// Takes the magnitudes of the motion below away from the limits. Rejects a limit of which nothing
/// is left.
std::optional<Refusal> take_away(Limits& limits, const Peaks& below) {
  constexpr double least = 1e-9;  // relative to a limit
  const auto take = [](double& limit, double used, double order) -> std::optional<Refusal> {
    const double most = std::exchange(limit, limit - used);
    if (limit > least * most) return std::nullopt;
    return Refusal{Cause::no_reserve, used, most, order};
  };
  if (auto no = take(*limits.velocity, below.velocity, 1)) return no;
  if (auto no = take(*limits.acceleration, below.acceleration, 2)) return no;
  return limits.jerk ? take(*limits.jerk, below.jerk, 3) : std::nullopt;
}

/// True if a motion keeps these limits.
bool keeps(const Profile& motion, const Limits& limits) {
  constexpr double slack = 1 + 1e-9;
  const Peaks most = peaks(motion);
  return most.velocity <= *limits.velocity * slack &&
         most.acceleration <= *limits.acceleration * slack &&
         (!limits.jerk || most.jerk <= *limits.jerk * slack);
}

/// True if the motion below needs more than before, or notably less.
bool differs(const Peaks& now, const Peaks& before, const Limits& limits) {
  constexpr double rounding = 1e-9;  // relative to a limit
  constexpr double notable = 0.1;    // relative to a limit
  const auto changes = [](double value, double old, double limit) {
    return value > old + rounding * limit || value < old - notable * limit;
  };
  return changes(now.velocity, before.velocity, *limits.velocity) ||
         changes(now.acceleration, before.acceleration, *limits.acceleration) ||
         (limits.jerk && changes(now.jerk, before.jerk, *limits.jerk));
}

/// Leaves in the limits what the motion below does not need. A thousandth always remains, so that
/// the move ends.
void leave_rest(Limits& limits, const Peaks& below, double stop_jerk) {
  constexpr double least = 1e-3;
  const auto leave = [](double& limit, double used) {
    limit = std::max(limit - used, least * limit);
  };
  // The curvature of the motion below within a tick and, with a jerk limit, the velocity that comes
  // while its acceleration falls to 0 (exceeds_velocity() in setpoint_check.hpp), twice: that of the
  // sum falls from a greater value.
  const double a = below.acceleration;
  const double rising = limits.jerk ? a * a / stop_jerk : 0;
  leave(*limits.velocity, below.velocity + rising + least * *limits.velocity);
  leave(*limits.acceleration, below.acceleration);
  if (limits.jerk) leave(*limits.jerk, below.jerk);
}

/// The dynamics, at most as great as the limits.
MoveDynamics lowered_to(MoveDynamics d, const Limits& limits) {
  const auto lower = [](double& value, double limit) {
    if (!std::isnan(value)) value = std::min(value, limit);
  };
  lower(d.velocity, *limits.velocity);
  lower(d.acceleration, *limits.acceleration);
  lower(d.deceleration, *limits.acceleration);
  if (limits.jerk) lower(d.jerk, *limits.jerk);
  return d;
}

std::optional<Refusal> outside(double target, const Limits& limits) {
  if (limits.position_min && target < *limits.position_min)
    return Refusal{Cause::position_limit, target, *limits.position_min};
  if (limits.position_max && target > *limits.position_max)
    return Refusal{Cause::position_limit, target, *limits.position_max};
  return std::nullopt;
}

}  // namespace

std::optional<Refusal> SuperimposedMove::begin(std::int64_t tick, double distance,
                                               MoveDynamics dynamics, const Peaks& below,
                                               std::optional<double> end) noexcept {
  AxisConfig left = config_;
  const MoveDynamics asked = dynamics;
  if (auto no = take_away(left.limits, below)) return no;
  if (auto no = fill(dynamics, left)) return no;
  if (end && !running_)
    if (auto no = outside(*end + distance, config_.limits)) return no;
  const Motion up = running_ ? profile_.at(time(tick)) : Motion{};
  const Goal goal{Goal::Kind::position, up.position + distance, dynamics};
  left.limits.position_min = left.limits.position_max = std::nullopt;
  const Limits before = std::exchange(most_, left.limits);
  const auto profile = planned(up, goal, 1);
  if (!profile || !keeps(*profile, most_)) {
    most_ = before;
    return Refusal{Cause::no_such_move, distance, 0};
  }
  running_ = true;
  held_ = false;
  profile_ = *profile;
  goal_ = goal;
  origin_ = tick;
  asked_ = asked;
  below_ = below;
  return std::nullopt;
}

void SuperimposedMove::fit(std::int64_t tick, const Peaks& below) noexcept {
  if (!running_ || held_ || !differs(below, below_, config_.limits)) return;
  AxisConfig left = config_;
  leave_rest(left.limits, below, config_.stop_jerk);
  left.limits.position_min = left.limits.position_max = std::nullopt;
  Goal goal = goal_;
  goal.dynamics = lowered_to(asked_, left.limits);
  if (fill(goal.dynamics, left)) return;
  Motion from = profile_.at(time(tick));
  const double a = *left.limits.acceleration;
  from.acceleration = std::clamp(from.acceleration, -a, a);
  const double v = *left.limits.velocity;
  if (const double excess = from.velocity - std::clamp(from.velocity, -v, v); excess != 0) {
    // The motion below has taken this velocity in the last tick, in equal parts.
    from.velocity -= excess;
    from.position -= excess * seconds(config_.period) / 2;
    from.acceleration =
        excess > 0 ? std::min(from.acceleration, 0.0) : std::max(from.acceleration, 0.0);
  }
  const Limits before = std::exchange(most_, left.limits);
  const auto profile = planned(from, goal, 1);
  if (!profile) {
    most_ = before;
    return;
  }
  profile_ = *profile;
  goal_ = goal;
  origin_ = tick;
  below_ = below;
}

void SuperimposedMove::add_to(Setpoint& next, std::int64_t tick) noexcept {
  next.slave[0] += finished_;
  if (!running_) return;
  const double t = time(tick);
  const auto [p, v, a, j] = profile_.at(t);
  next.slave[0] += p;
  next.slave[1] += v;
  next.slave[2] += a;
  next.slave[3] += j;
  if (t < profile_.duration() || held_) return;
  running_ = false;
  finished_ += profile_.end().position;
}

bool SuperimposedMove::hold(bool on, std::int64_t tick) noexcept {
  if (!running_ || on == held_) return true;
  const std::int64_t from = std::max(tick, origin_);
  const auto profile = planned(profile_.at(time(from)), goal_, on ? 0 : 1);
  if (!profile) return false;
  profile_ = *profile;
  origin_ = from;
  held_ = on;
  return true;
}

void SuperimposedMove::clear() noexcept {
  running_ = false;
  finished_ = 0;
}

double SuperimposedMove::remaining(std::int64_t tick) const noexcept {
  return running_ ? goal_.value - profile_.at(time(tick)).position : 0;
}

Peaks SuperimposedMove::peaks() const noexcept {
  if (!running_) return {};
  return {*most_.velocity, *most_.acceleration, most_.jerk.value_or(0)};
}

double SuperimposedMove::time(std::int64_t tick) const noexcept {
  return seconds((tick - origin_) * config_.period);
}

std::optional<Profile> SuperimposedMove::planned(const Motion& from, const Goal& goal,
                                                 double factor) const noexcept {
  AxisConfig left = config_;
  left.limits = most_;
  return plan({from.position, from.velocity, from.acceleration}, goal, factor, left);
}

}  // namespace jounce
