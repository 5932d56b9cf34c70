// SPDX-License-Identifier: Apache-2.0
#include "jounce/axis/detail/path_clock.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "jounce/profiles/moves/move.hpp"

// Stop, hold and override on a path. The axis still plays the table, but the time s of the table
// runs at a rate r(t) = ds/dt. The position therefore never leaves the path. By the chain rule,
// with p(s) the table,
//
//     (1)  velocity      p' r
//     (2)  acceleration  p'' r^2 + p' r'
//     (3)  jerk          p''' r^3 + 3 p'' r r' + p' r''
//
// Let V, A, J be the peaks of velocity, acceleration and jerk of the table and h >= r the highest
// rate during a change. The change keeps the limits a and j everywhere on the path if |r'| <= R and
// |r''| <= 2 R^2 with
//
//     (4)  A h^2 + V R <= a                          that is  R <= (a - A h^2) / V
//     (5)  J h^3 + 3 A h R + 2 V R^2 <= j            that is  R <= 2c / (b + sqrt(b^2 + 8 V c)),
//                                                             b = 3 A h, c = j - J h^3
//
// The fastest change of the rate by 1 under these bounds has |r'| rising for 1/(2R), constant for
// 1/(2R) and falling for 1/(2R): its duration is
//
//     (6)  D = 3 / (2R)
//
// By symmetry it covers D/2 of path time. It is a velocity move (jounce/profiles/moves/move.hpp)
// whose "velocity" is the rate. Such a move may start from any state, and a new change may
// interrupt it. On a ramp to a rate, r' can always fall to 0 before r passes that rate. Therefore r
// stays between the old and the new rate, and path time never runs backwards.
//
// A step of the velocity within the table counts as the acceleration that makes it in one tick. At
// rates above 1, a tick may contain twice as many steps.

namespace jounce {
namespace {

double tick_acceleration(const Peaks& peaks, const AxisConfig& config) {
  return std::max(peaks.acceleration, peaks.velocity_step / seconds(config.period));
}

Bounds rate_bounds(double slope) {
  return {.acceleration_min = -slope,
          .acceleration_max = slope,
          .jerk_min = -2 * slope * slope,
          .jerk_max = 2 * slope * slope};
}

}  // namespace

void PathClock::start(std::int64_t tick, double s, double rate) noexcept {
  origin_ = tick;
  base_ = s;
  change_ = Profile({0, rate, 0}, 3);
  length_ = 0;
  top_ = rate;
}

double PathClock::since(std::int64_t tick) const noexcept {
  return seconds((tick - origin_) * period_);
}

bool PathClock::change(std::int64_t tick, double rate, double slope) noexcept {
  if (!(rate >= 0 && slope > 0)) return false;
  tick = std::max(tick, origin_);
  const PathTime now = at(tick);
  const MoveResult move = move_velocity({0, now.rate, now.rate_slope}, rate, rate_bounds(slope));
  if (!move) return false;
  top_ = std::max(highest(tick), rate);
  origin_ = tick;
  base_ = now.s;
  change_ = move.profile;
  length_ = change_.duration();
  return true;
}

PathTime PathClock::at(std::int64_t tick) const noexcept {
  const double t = since(tick);
  if (t >= length_) {
    const MotionState& end = change_.end();
    return {base_ + (end.position - end.velocity * length_) + end.velocity * t, end.velocity, 0, 0};
  }
  const Motion now = change_.at(t);
  return {base_ + now.position, std::max(now.velocity, 0.0), now.acceleration, now.jerk};
}

bool PathClock::steady(std::int64_t tick) const noexcept {
  return since(tick) >= length_;
}

double PathClock::highest(std::int64_t tick) const noexcept {
  return steady(tick) ? target() : top_;
}

double PathClock::way_to_rest(std::int64_t tick, double slope) const noexcept {
  const PathTime now = at(tick);
  if (target() == 0) return base_ + change_.end().position - now.s;
  const MoveResult move = move_velocity({0, now.rate, now.rate_slope}, 0, rate_bounds(slope));
  return move ? move.profile.end().position : 0;
}

double PathClock::way_by(std::int64_t tick, double rate, double slope) const noexcept {
  PathClock ahead = *this;
  const double from = at(tick).s;
  for (const double next : {rate, 1.0, 0.0}) {
    if (!ahead.change(tick, next, slope)) return std::numeric_limits<double>::infinity();
    tick += static_cast<std::int64_t>(std::ceil(ahead.length_ / seconds(period_)));
  }
  return ahead.at(tick).s - from;
}

Setpoint at_rate(const Setpoint& path, const PathTime& time) noexcept {
  const auto& [s, r, dr, ddr] = time;
  if (r == 1 && dr == 0 && ddr == 0) return path;
  const auto& [p, v, a, j] = path.slave;
  return {path.master,
          path.master_velocity * r,
          {p, v * r, a * r * r + v * dr, j * r * r * r + 3 * a * r * dr + v * ddr}};  // (1) to (3)
}

double highest_rate(const Peaks& peaks, const AxisConfig& config) noexcept {
  const auto ratio = [](double limit, double peak) { return peak > 0 ? limit / peak : 8.0; };
  const Limits& limits = config.limits;
  double rate = std::min({2.0, ratio(*limits.velocity, peaks.velocity),
                          std::sqrt(ratio(*limits.acceleration, peaks.acceleration))});
  if (limits.jerk) rate = std::min(rate, std::cbrt(ratio(*limits.jerk, peaks.jerk)));
  if (peaks.velocity_step > 0)
    rate =
        std::min(rate, *limits.acceleration * seconds(config.period) / (2 * peaks.velocity_step));
  return std::max(rate, 1.0);
}

double rate_slope(const Peaks& peaks, const AxisConfig& config, double h,
                  const Peaks& added) noexcept {
  const double V = peaks.velocity;
  const double A = tick_acceleration(peaks, config);
  double R = std::min(1.5 / seconds(config.period),
                      (config.stop_acceleration - added.acceleration - A * h * h) / V);  // (4)
  if (!config.limits.jerk) return R;
  const double b = 3 * A * h;
  const double c = config.stop_jerk - added.jerk - peaks.jerk * h * h * h;
  R = std::min(R, 2 * c / (b + std::sqrt(b * b + 8 * V * std::max(c, 0.0))));  // (5)
  return R;
}

double stop_duration(const Peaks& peaks, const AxisConfig& config) {
  return 1.5 / rate_slope(peaks, resolved(config), 1);  // (6)
}

}  // namespace jounce
