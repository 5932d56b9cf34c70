// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>
#include <vector>

#include "jounce/axis/axis.hpp"

namespace jounce::test {

/// Conditions on the log of an axis, for all commands: docs/executor/axis.md, "Invariants of the
/// log". It reads the ticks and the configured limits, and nothing else of the axis.
class LimitsOfLog {
 public:
  explicit LimitsOfLog(const AxisConfig& config) : config_(resolved(config)) {}

  /// The condition that the last tick violates, as text; empty: none.
  std::string see(const Tick& now) {
    const std::string wrong = seen_ ? broken(now) : "";
    before_ = now;
    seen_ = true;
    return wrong;
  }

 private:
  static constexpr double same = 1 + 1e-8;

  static bool rests(const Tick& tick) {
    return tick.state == State::standstill || tick.state == State::disabled ||
           tick.state == State::homing;
  }
  /// The setpoint froze: an abort without its own deceleration, a drive that lets go, a cycle too late.
  [[nodiscard]] bool froze(const Tick& now) const {
    const bool began = now.fault != Cause::none && before_.fault == Cause::none;
    const bool at_once = now.fault == Cause::stalled || !now.power ||
                         (now.fault == Cause::aborted && config_.abort_acceleration == 0);
    // A second abort, or a drive that lets go, ends the braking of a fault.
    const bool again = before_.state == State::error_stop && now.velocity == 0;
    return (began && at_once) || again || (before_.power && !now.power);
  }
  /// It is a stop, or the change of a rate, or was one a tick ago: the stop limits hold.
  [[nodiscard]] bool stops(const Tick& now) const {
    const auto by_stop = [](const Tick& tick) {
      return tick.state == State::stopping || tick.state == State::error_stop ||
             tick.state == State::synchronized_motion || (tick.job != 0 && tick.rate != 1);
    };
    return by_stop(now) || by_stop(before_);
  }

  [[nodiscard]] std::string broken(const Tick& now) const {
    const auto wrong = [&](const char* what, double value, double limit) {
      std::ostringstream text;
      text.precision(17);
      text << what << ' ' << value << " of " << limit << " in tick " << now.tick;
      return text.str();
    };
    const Limits& most = config_.limits;
    if (rests(now) && (now.velocity != 0 || now.acceleration != 0))
      return wrong("velocity at rest", now.velocity, 0);
    const bool renamed = now.offset != before_.offset || before_.state == State::disabled;
    if (renamed) return "";
    const double way = now.position - before_.position;
    if (rests(now) && rests(before_) && std::abs(way) > 1e-12 * (1 + std::abs(now.position)))
      return wrong("way at rest", way, 0);
    if (std::abs(now.velocity) > *most.velocity * same)
      return wrong("velocity", now.velocity, *most.velocity);
    if (const double out = outside(now.position); out > outside(before_.position) + 1e-8)
      return wrong("outside the range by", out, 0);
    if (froze(now)) return "";

    const double tick = static_cast<double>(config_.period) * 1e-9;
    const double dt = static_cast<double>(now.tick - before_.tick) * tick;
    const bool by_fault = now.state == State::error_stop;
    const double own = std::max(config_.abort_acceleration, config_.limit_acceleration);
    const double s = std::max(config_.stop_acceleration, by_fault ? own : 0);
    const bool as_stop = stops(now);
    const double a = as_stop ? s : std::max(*most.acceleration, std::abs(before_.acceleration));
    if (std::abs(now.acceleration) > a * same) return wrong("acceleration", now.acceleration, a);
    const double step = now.velocity - before_.velocity;
    // Paths may begin, end and join with what the acceleration makes in a tick.
    const double joint = *most.acceleration * tick;
    if (std::abs(step) > (s * dt + joint) * same) return wrong("change of velocity", step, s * dt);
    const double beside = way - (now.velocity + before_.velocity) / 2 * dt;
    const bool joins = now.job != before_.job;  // its velocity may step
    if (!joins && std::abs(beside) > (s * dt + joint) * dt / 2 + 1e-9)
      return wrong("way", beside, s * dt * dt);
    if (!most.jerk || now.state == State::synchronized_motion ||
        before_.state == State::synchronized_motion)
      return "";
    const double j = config_.stop_jerk * dt + *most.jerk * tick;
    const double change = now.acceleration - before_.acceleration;
    return std::abs(change) > j * same ? wrong("change of acceleration", change, j) : "";
  }

  [[nodiscard]] double outside(double position) const {
    const auto& [low, high, v, a, j] = config_.limits;
    return std::max({0.0, low ? *low - position : 0.0, high ? position - *high : 0.0});
  }

  AxisConfig config_;
  bool seen_ = false;
  Tick before_;
};

}  // namespace jounce::test
