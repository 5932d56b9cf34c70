// SPDX-License-Identifier: Apache-2.0
#include "axis/src/motion/superimposed_move.hpp"

#include <algorithm>
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
  return std::nullopt;
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
