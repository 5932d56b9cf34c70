// SPDX-License-Identifier: Apache-2.0
#include "axis/src/follow/phase_player.hpp"

#include <algorithm>
#include <cmath>

#include "jounce/profiles/detail/tolerances.hpp"

#include "axis/src/follow/coupled_peaks.hpp"
#include "axis/src/motion/move_plan.hpp"

namespace jounce {
namespace {

using profiles_detail::rounded_input;

constexpr double share_of_cam = 0.5;  ///< share of the acceleration limit; see the header

/// (1), (2), (3) for a shift with these magnitudes, m/s, m/s^2, m/s^3.
Peaks needed(const PhaseBase& base, const Peaks& shift) {
  const Peaks slave =
      coupled_peaks(base.slopes, {.velocity = std::abs(base.master[1]) + shift.velocity,
                                  .acceleration = std::abs(base.master[2]) + shift.acceleration,
                                  .jerk = std::abs(base.master[3]) + shift.jerk});
  return {.velocity = slave.velocity + base.other.velocity,
          .acceleration = slave.acceleration + base.other.acceleration,
          .jerk = slave.jerk + base.other.jerk};
}

std::optional<Refusal> against(const Peaks& need, const Limits& limits) {
  const auto exceeds = [](double value, double limit) {
    return !(value <= limit * (1 + rounded_input));
  };
  if (exceeds(need.velocity, *limits.velocity))
    return Refusal{Cause::velocity_limit, need.velocity, *limits.velocity};
  if (exceeds(need.acceleration, *limits.acceleration))
    return Refusal{Cause::acceleration_limit, need.acceleration, *limits.acceleration};
  if (limits.jerk && exceeds(need.jerk, *limits.jerk))
    return Refusal{Cause::jerk_limit, need.jerk, *limits.jerk};
  return std::nullopt;
}

/// Sets the values that are not given. A value stays 0 or negative if nothing is left of its limit.
void fill(MoveDynamics& d, const PhaseBase& base, const Limits& limits) {
  const auto [k1, k2, k3] = base.slopes;
  const double a_left = *limits.acceleration - base.other.acceleration;
  if (std::isnan(d.velocity)) {
    d.velocity = (*limits.velocity - base.other.velocity) / k1;
    if (k2 > 0)
      d.velocity = std::min(d.velocity, std::sqrt(std::max(0.0, share_of_cam * a_left / k2)));
    d.velocity -= std::abs(base.master[1]);
  }
  const double w = std::abs(base.master[1]) + d.velocity;
  const double a_most = (a_left - k2 * w * w) / k1 - std::abs(base.master[2]);
  if (std::isnan(d.acceleration)) d.acceleration = a_most;
  if (std::isnan(d.deceleration)) d.deceleration = a_most;
  const double a = std::abs(base.master[2]) + std::max(d.acceleration, d.deceleration);
  if (!std::isnan(d.jerk)) return;
  d.jerk = Bounds::none;
  if (limits.jerk)
    d.jerk = (*limits.jerk - base.other.jerk - 3 * k2 * w * a - k3 * w * w * w) / k1 -
             std::abs(base.master[3]);
}

/// The refusal of dynamics of which nothing is left, or that the command gave as 0 or less.
std::optional<Refusal> unusable(const MoveDynamics& d, const MoveDynamics& given,
                                const PhaseBase& base, const Limits& limits) {
  const Peaks least =
      needed(base, {std::max(d.velocity, 0.0), std::max(d.acceleration, 0.0), 0, 0});
  const auto no = [](double value, double asked, Cause cause, double need, double limit) {
    if (value > 0) return std::optional<Refusal>();
    return std::optional(std::isnan(asked) ? Refusal{cause, need, limit}
                                           : Refusal{Cause::not_positive, value, 0});
  };
  if (auto r =
          no(d.velocity, given.velocity, Cause::velocity_limit, least.velocity, *limits.velocity))
    return r;
  for (const auto& [value, asked] :
       {std::pair{d.acceleration, given.acceleration}, {d.deceleration, given.deceleration}})
    if (auto r =
            no(value, asked, Cause::acceleration_limit, least.acceleration, *limits.acceleration))
      return r;
  return no(d.jerk, given.jerk, Cause::jerk_limit, least.jerk, limits.jerk.value_or(0));
}

}  // namespace

std::optional<Refusal> PhasePlayer::begin(std::int64_t tick, double target,
                                          const MoveDynamics& dynamics, const PhaseBase& base,
                                          const AxisConfig& config) noexcept {
  if (!(base.slopes[0] > 0)) return Refusal{Cause::no_such_move, target, 0};
  MoveDynamics d = dynamics;
  fill(d, base, config.limits);
  if (const auto no = unusable(d, dynamics, base, config.limits)) return no;
  AxisConfig master;  // the limits of the shift
  master.period = config.period;
  master.limits.velocity = d.velocity;
  master.limits.acceleration = master.stop_acceleration = std::max(d.acceleration, d.deceleration);
  if (std::isfinite(d.jerk)) master.limits.jerk = master.stop_jerk = d.jerk;
  const Jet now = at(tick);
  const auto profile = plan({now[0], now[1], now[2]}, {Goal::Kind::position, target, d}, 1, master);
  if (!profile) return Refusal{Cause::no_such_move, target, 0};
  // The shift that is replaced may be faster than these dynamics.
  const Peaks reached = jounce::peaks(*profile);
  const double most = std::max(d.acceleration, d.deceleration);
  const Peaks need =
      needed(base, {std::max(reached.velocity, d.velocity), std::max(reached.acceleration, most),
                    std::max(reached.jerk, std::isfinite(d.jerk) ? d.jerk : 0)});
  if (const auto no = against(need, config.limits)) return no;
  const Peaks without = needed(base, {});
  added_ = {need.velocity - without.velocity, need.acceleration - without.acceleration,
            need.jerk - without.jerk, 0};
  profile_ = *profile;
  origin_ = tick;
  shifts_ = true;
  return std::nullopt;
}

Jet PhasePlayer::at(std::int64_t tick, double t) const noexcept {
  if (!shifts_) return {};
  const double now = time(tick) + t;
  if (now >= profile_.duration()) return {profile_.end().position, 0, 0, 0};
  const auto [p, v, a, j] = profile_.at(std::max(now, 0.0));
  return {p, v, a, j};
}

bool PhasePlayer::moves(std::int64_t tick) const noexcept {
  return shifts_ && time(tick) < profile_.duration();
}

Peaks PhasePlayer::peaks(std::int64_t tick) const noexcept {
  return moves(tick) ? added_ : Peaks{};
}

double PhasePlayer::time(std::int64_t tick) const noexcept {
  return seconds((tick - origin_) * period_);
}

}  // namespace jounce
