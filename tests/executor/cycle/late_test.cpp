// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include <gtest/gtest.h>

#include "jounce/executor/detail/cycle.hpp"

#include "axis/tables.hpp"
#include "executor/rig.hpp"

namespace jounce::late_test {
namespace {

using namespace test;

constexpr double velocity = 10;
constexpr double acceleration = 20;
constexpr std::int64_t period = 1'000'000;
constexpr std::int64_t gap = 100;  // AxisConfig::longest_gap

/// From one setpoint to the next the axis may do what its limits allow in the time between, with a
/// stop's twofold acceleration.
void expect_within_limits(const Tick& before, const Tick& now) {
  const double dt = static_cast<double>(now.tick - before.tick) * 1e-3;
  EXPECT_LE(std::abs(now.position - before.position), velocity * dt * (1 + 1e-9));
  EXPECT_LE(std::abs(now.velocity), velocity * (1 + 1e-9));
  if (now.fault == Cause::none) {
    EXPECT_LE(std::abs(now.velocity - before.velocity), 2 * acceleration * dt + 1e-9);
  }
}

/// Plays the table, late by `late` whole periods and a little more in the cycle that is due `after`
/// ticks after the start.
void play_late(const TablePtr& move, std::int64_t after, std::int64_t late) {
  SCOPED_TRACE(::testing::Message() << "late by " << late << " after " << after);
  Job job(1, move);
  Rig rig({.limits = limits(velocity, acceleration), .longest_gap = gap});
  rig.order({command::Enable{}});
  rig.order({command::Arm{.movement = &job}});
  rig.pacer.delay = after == 0 ? late * period + period / 3 : 0;
  Tick before = rig.order({command::Start{}});
  const std::int64_t start = before.tick;
  for (int steps = 1; before.job != 0; ++steps) {
    ASSERT_LT(steps, 20'000) << "it does not end";
    const bool now_late = before.tick - start + 1 == after;
    if (now_late) rig.pacer.delay = late * period + period / 3;
    const Tick now = rig.next();
    EXPECT_EQ(now.tick, before.tick + 1 + (now_late ? late : 0)) << "a burst, or a tick lost";
    expect_within_limits(before, now);
    if (now.job != 0 && now.state == State::discrete_motion) {
      EXPECT_EQ(now.position, move->jet(static_cast<double>(now.tick - start) / 1e3)[0]);
    }
    before = now;
  }
  for (int i = 0; i < 3000 && before.velocity != 0; ++i) {  // a fault may end in a stop
    const Tick now = rig.next();
    expect_within_limits(before, now);
    before = now;
  }
  EXPECT_EQ(before.velocity, 0);
  const auto length = static_cast<std::int64_t>(std::lround(move->length() * 1e3));
  const bool too_far = after > 0 && late >= gap && after <= length;
  EXPECT_EQ(before.fault, too_far ? Cause::stalled : Cause::none);
  if (!too_far) {
    EXPECT_EQ(before.position, move->jet(move->end())[0]);
  }
}

// A trapezoid at both limits: 500 ms of ramp, 4.5 s at full speed, 500 ms of ramp. The worst places
// are the first tick, full acceleration, both ends of the ramps, full speed, and the last tick.
TEST(Late, TheMotionIsWhereTheTimeIsWhateverTheCycleMisses) {
  const TablePtr move = trapezoid_table(50, velocity, acceleration, acceleration);
  for (const std::int64_t late : {1, 10, 99, 100, 5000})
    for (const std::int64_t after : {0, 1, 250, 499, 500, 2750, 4999, 5000, 5001, 5499, 5500, 5501})
      play_late(move, after, late);
}

TEST(Late, ATableOfOneTickIsOverWhenTheCycleComesBack) {
  const TablePtr move = there_and_back(0, 1e-6, 0.002, Extrapolation::hold);
  for (const std::int64_t late : {1, 10, 99, 100, 5000}) play_late(move, 1, late);
}

// Every tenth cycle late by another number of periods: bit for bit on the path all the same.
TEST(Late, AgainAndAgain) {
  const TablePtr move = there_and_back(0, 5, 3, Extrapolation::wrap);
  Job job(1, move);
  Rig rig({.limits = limits(velocity, acceleration), .longest_gap = gap});
  rig.order({command::Enable{}});
  rig.order({command::Arm{.movement = &job}});
  Tick before = rig.order({command::Start{}});
  const std::int64_t start = before.tick;
  for (int i = 0; i < 5000; ++i) {
    const std::int64_t late = i % 10 == 0 ? i % 97 : 0;
    rig.pacer.delay = late * period;
    const Tick now = rig.next();
    ASSERT_EQ(now.skipped, late);
    ASSERT_EQ(now.position,
              move->jet(std::fmod(static_cast<double>(now.tick - start) / 1e3, 3))[0]);
    expect_within_limits(before, now);
    before = now;
  }
  EXPECT_EQ(rig.cycle.counts().late, 494);
  EXPECT_EQ(before.fault, Cause::none);
}

}  // namespace
}  // namespace jounce::late_test
