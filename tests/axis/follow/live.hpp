// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>

#include "jounce/axis/movement.hpp"

namespace jounce::test {

/// A slave behind a live master, without an axis, stepped cycle by cycle.
struct Follower {
  Movement& movement;
  std::function<Jet(double)> master;
  double period = 1e-3;
  std::int64_t tick = 0;

  Moment moment(double dt) const {
    const double t = static_cast<double>(tick) * period;
    return {t, dt, master(t)};
  }
  Cause begin(const MotionState& axis) { return movement.begin(axis, moment(0)); }
  Setpoint now() { return movement.at(moment(period)); }
  Setpoint step() {
    ++tick;
    return movement.at(moment(period));
  }
  Setpoint run(std::int64_t ticks) {
    Setpoint last;
    for (std::int64_t i = 0; i < ticks; ++i) last = step();
    return last;
  }
};

/// A master of constant velocity, from 0.
inline std::function<Jet(double)> steady(double velocity) {
  return [=](double t) { return Jet{velocity * t, velocity, 0, 0}; };
}

}  // namespace jounce::test
