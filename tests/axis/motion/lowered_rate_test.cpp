// SPDX-License-Identifier: Apache-2.0
// A rate that is above full speed and comes down for a swap, or must not go up, and commands during
// that time.

#include <cmath>

#include <gtest/gtest.h>

#include "jounce/axis/axis.hpp"
#include "jounce/axis/job.hpp"

#include "axis/tables.hpp"

namespace jounce::lowered_rate_test {
namespace {

using namespace test;

/// A table at twice its speed, and one that takes full speed only armed to follow it; two ticks later
/// the rate is on its way down.
struct Lowering {
  Lowering() {
    bench.play(fast);
    bench.step({command::Override{.factor = 2}});
    EXPECT_EQ(bench.run(300).rate, 2);
    arm();
    EXPECT_LT(bench.run(2).rate, 2);
  }
  void arm() {
    bench.arm(slow);
    EXPECT_EQ(refusal(bench.step({command::Start{.when = StartAt::end_of_table}})), Cause::none);
  }

  Job fast{1, there_and_back(0, 10, 2, Extrapolation::wrap)};    // 58 u/s^2
  Job slow{2, there_and_back(0, 10, 0.5, Extrapolation::hold)};  // 924 u/s^2
  Bench bench{{.limits = limits(100, 1000)}};
};

TEST(LoweredRate, AStopStaysOnThePath) {
  for (const Kind kind : {Kind::stop, Kind::halt}) {
    Lowering at;
    EXPECT_EQ(refusal(at.bench.send(kind)), Cause::none);
    Tick tick;
    for (int i = 0; i < 2000; ++i) {
      tick = at.bench.step();
      if (tick.state == State::standstill) break;
      ASSERT_EQ(tick.job, 1U) << "on its path";
    }
    EXPECT_EQ(tick.state, State::standstill);
  }
}

TEST(LoweredRate, AHoldAndAnOverrideAreTaken) {
  Lowering held;
  EXPECT_EQ(refusal(held.bench.send(Kind::hold)), Cause::none);
  Tick tick = held.bench.run(200);
  EXPECT_EQ(tick.job, 1U);
  EXPECT_EQ(tick.rate, 0);
  Lowering slower;
  EXPECT_EQ(refusal(slower.bench.step({command::Override{.factor = 0.5}})), Cause::none);
  tick = slower.bench.run(200);
  EXPECT_EQ(tick.job, 1U);
  EXPECT_EQ(tick.rate, 0.5);
}

TEST(LoweredRate, GoesUpAgainWhereAnotherIsArmedInstead) {
  Lowering at;
  EXPECT_NEAR(at.bench.run(100).rate, std::sqrt(1000 / 923.76), 1e-3) << "what the next one takes";
  Job other(3, there_and_back(0, 5, 2, Extrapolation::hold));
  EXPECT_EQ(refusal(at.bench.arm(other)), Cause::none);
  const Tick tick = at.bench.run(300);
  EXPECT_EQ(tick.rate, 2);
  EXPECT_EQ(tick.override_, 2);
}

// A superimposed move was given what the factor left of the velocity.
TEST(LoweredRate, AnOverrideDoesNotRiseWhileAMoveIsSuperimposed) {
  Bench bench{{.limits = limits(1, 10)}};
  bench.send(Kind::enable);
  bench.step({command::MoveAbsolute{
      .position = 2, .dynamics = {.velocity = 0.5, .acceleration = 5, .deceleration = 5}}});
  bench.run(200);
  EXPECT_EQ(refusal(bench.step({command::MoveSuperimposed{.distance = 0.3}})), Cause::none);
  bench.run(150);
  EXPECT_EQ(refusal(bench.step({command::Override{.factor = 2}})), Cause::in_motion);
  EXPECT_EQ(refusal(bench.step({command::Override{.factor = 0.5}})), Cause::none);
  const Tick tick = bench.run(10'000);
  EXPECT_EQ(tick.fault, Cause::none);
  EXPECT_NEAR(tick.position, 2.3, 1e-9);
}

TEST(LoweredRate, NorOnAPath) {
  Bench bench{{.limits = limits(100, 1000)}};
  Job table(1, there_and_back(0, 10, 2, Extrapolation::wrap));
  bench.play(table, 100);
  EXPECT_EQ(refusal(bench.step({command::MoveSuperimposed{.distance = 1}})), Cause::none);
  EXPECT_EQ(refusal(bench.step({command::Override{.factor = 2}})), Cause::in_motion);
  const Tick tick = bench.run(1000);
  EXPECT_EQ(tick.fault, Cause::none);
  EXPECT_EQ(tick.rate, 1);
  EXPECT_EQ(refusal(bench.step({command::Override{.factor = 2}})), Cause::none) << "over";
}

}  // namespace
}  // namespace jounce::lowered_rate_test
