// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include <gtest/gtest.h>

#include "jounce/axis/axis.hpp"
#include "jounce/axis/job.hpp"

#include "axis/model/any_command.hpp"

namespace jounce::test {

using Kind = CommandKind;

inline Limits limits(double velocity, double acceleration) {
  Limits limits;
  limits.velocity = velocity;
  limits.acceleration = acceleration;
  return limits;
}

inline Limits limits(double velocity, double acceleration, double jerk) {
  Limits with_jerk = limits(velocity, acceleration);
  with_jerk.jerk = jerk;
  return with_jerk;
}

/// Why the command of this tick was refused; none where it was not.
inline Cause refusal(const Tick& tick) {
  return tick.refused ? tick.refused->cause : Cause::none;
}

/// A master at m, at v a second.
inline Inputs at_master(double m, double v) {
  Inputs inputs;
  inputs.master = {m, v, 0, 0};
  return inputs;
}

/// An axis with its tick counter.
struct Bench {
  explicit Bench(const AxisConfig& config, const AxisSwitches& switches = {})
      : axis(config, switches) {}

  Tick step(const Command& command = {}, const Inputs& inputs = {}) {
    return axis.step(++tick, command, inputs);
  }
  Tick send(Kind kind) { return step(any({.kind = kind})); }
  Tick arm(Movement& movement) { return step({command::Arm{.movement = &movement}}); }
  Tick run(std::int64_t ticks) {
    Tick last;
    for (std::int64_t i = 0; i < ticks; ++i) last = step();
    return last;
  }
  /// Enabled, armed with this, and started: the tick of local time 0, or so many later.
  Tick play(Movement& movement, std::int64_t ticks = 0) {
    send(Kind::enable);
    EXPECT_EQ(refusal(arm(movement)), Cause::none);
    const Tick first = send(Kind::start);
    return ticks > 0 ? run(ticks) : first;
  }

  MotionAxis axis;
  std::int64_t tick = -1;
};

}  // namespace jounce::test
