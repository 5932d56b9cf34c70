// SPDX-License-Identifier: Apache-2.0
// What an axis does where two things fall into the same tick.
#include <cmath>

#include <gtest/gtest.h>

#include "jounce/axis/axis.hpp"

#include "axis/model/model_movements.hpp"
#include "axis/tables.hpp"
#include "support/loop_limit.hpp"

namespace jounce::axis_coincidence_test {
namespace {

using namespace test;

const AxisConfig wide{.limits = limits(200, 1000)};

AnyCommand to(double position, double velocity, BufferMode buffer = BufferMode::aborting) {
  return {.kind = Kind::move_absolute,
          .position = position,
          .dynamics = {.velocity = velocity},
          .buffer = buffer};
}

// The move that waited for this tick has just begun, after a long rest: a command about it is
// planned from here, not from the place of the last motion.
TEST(AxisCoincidence, AMoveAtATickIsChangedInThatVeryTick) {
  for (const Command& change :
       {Command{command::Override{.factor = 0.5}}, any(to(20, 100)),
        any(to(40, 50, BufferMode::buffered)), Command{command::MoveAdditive{.distance = 5}}}) {
    Bench axis(wide);
    axis.send(Kind::enable);
    AnyCommand later = to(30, 100);
    later.at = 500;
    ASSERT_EQ(refusal(axis.step(later)), Cause::none);
    axis.run(498);
    Tick tick = axis.step(change);
    ASSERT_EQ(tick.tick, 500);
    EXPECT_EQ(tick.fault, Cause::none) << name(change.kind());
    EXPECT_EQ(tick.position, 0) << name(change.kind());
    tick = axis.step();
    EXPECT_NEAR(tick.position, 1000 * 1e-6 / 2, 1e-12)
        << name(change.kind()) << ": one tick of 1000 u/s^2";
    tick = axis.run(2000);
    EXPECT_EQ(tick.state, State::standstill) << name(change.kind());
    EXPECT_EQ(tick.fault, Cause::none) << name(change.kind());
  }
}

// Another axis of the group stops in the tick of a command: the command keeps its own answer.
TEST(AxisCoincidence, ACommandIsAnsweredInTheTickInWhichItsGroupBreaks) {
  Job job(1, there_and_back(0, 10, 1, Extrapolation::hold));
  const Command bad{command::MoveAbsolute{.position = NAN}};
  const Command good{command::Override{.factor = 0.5}};
  for (const Command& command : {bad, good}) {
    Bench axis(wide);
    axis.send(Kind::enable);
    axis.step({command::Arm{.movement = &job, .group = 42}});
    axis.send(Kind::start);
    axis.run(200);
    Inputs inputs;
    inputs.group_broken = true;
    const Tick now = axis.step(command, inputs);
    EXPECT_EQ(now.state, State::stopping);
    EXPECT_EQ(now.broken[0], 42);
    EXPECT_EQ(refusal(now), command.kind() == bad.kind() ? Cause::no_value : Cause::none);
  }
}

// A target is a position of the axis, also after a superimposed move.
TEST(AxisCoincidence, ABlendedMoveAfterASuperimposedOneEndsAtItsTarget) {
  Bench axis({.limits = limits(200, 1000)});
  axis.send(Kind::enable);
  AnyCommand first = to(100, 50);
  first.dynamics.acceleration = first.dynamics.deceleration = 500;
  axis.step(first);
  axis.run(100);
  ASSERT_EQ(
      refusal(axis.step({command::MoveSuperimposed{.distance = 5, .dynamics = {.velocity = 50}}})),
      Cause::none);
  axis.run(500);  // it is over
  ASSERT_EQ(refusal(axis.step(to(150, 50, BufferMode::blending_previous))), Cause::none);
  const Tick tick = axis.run(6000);
  EXPECT_EQ(tick.state, State::standstill);
  EXPECT_EQ(tick.finished, 2U);
  EXPECT_NEAR(tick.position, 150, 1e-9);
}

// The move behind it is taken back where this one can no longer stop before the end of the range: it
// does not stop dead at its target.
TEST(AxisCoincidence, ABlendedMoveIsTakenBackWithoutALeap) {
  AxisConfig config{.limits = limits(100, 10000)};
  config.limits.position_max = 52;
  config.limits.position_min = -10;
  Bench axis(config);
  axis.send(Kind::enable);
  AnyCommand first = to(50, 100);
  first.dynamics.acceleration = first.dynamics.deceleration = 200;  // 25 u from 100 u/s
  axis.step(first);
  ASSERT_EQ(refusal(axis.step(to(52, 100, BufferMode::blending_previous))), Cause::none);
  Tick last = axis.step();
  for (test::LoopLimit loop; last.position < 48 && loop.goes_on();) last = axis.step();
  ASSERT_GT(last.velocity, 90);
  Tick tick = axis.send(Kind::disarm);
  for (int i = 0; i < 3000; ++i) {
    ASSERT_LE(std::abs(tick.velocity - last.velocity), 10000 * 1e-3 * (1 + 1e-8)) << tick.position;
    last = tick;
    tick = axis.step();
  }
  EXPECT_EQ(tick.velocity, 0);
  EXPECT_LE(tick.position, 52 + 1e-9);
}

// The limit switch is reached in the tick in which the move passes its target and a gear is to take over.
TEST(AxisCoincidence, OntoALimitSwitchAtThePassedTarget) {
  for (const bool geared : {false, true}) {
    Bench axis(wide);
    Gear gear(1, 1);
    Inputs inputs;
    inputs.master = {0, 0, 0, 0};
    axis.step({command::Enable{}}, inputs);
    axis.step(to(50, 100), inputs);
    axis.step(to(80, 100, BufferMode::blending_previous), inputs);
    Tick tick = axis.step({}, inputs);
    for (test::LoopLimit loop; tick.position + tick.velocity * 1e-3 < 50 && loop.goes_on();)
      tick = axis.step({}, inputs);
    ASSERT_EQ(tick.finished, 0U);
    inputs.positive_switch = true;
    tick = geared ? axis.step({command::Couple{.movement = &gear}}, inputs) : axis.step({}, inputs);
    EXPECT_EQ(tick.state, State::error_stop);
    EXPECT_EQ(tick.fault, Cause::positive_switch);
    EXPECT_EQ(tick.handed_back[0], geared ? &gear : nullptr);
    EXPECT_EQ(axis.run(1000).velocity, 0);
  }
}

// The tick reports the waiting command.
TEST(AxisCoincidence, AMotionThatWaitsForItsTickIsReported) {
  Bench axis(wide);
  axis.send(Kind::enable);
  axis.step({.what = command::MoveAbsolute{.position = 10}, .at = 50});
  EXPECT_TRUE(in_motion(axis.step()));
  Inputs silent;
  silent.watchdog = true;
  EXPECT_EQ(axis.step({}, silent).fault, Cause::watchdog) << "as of a start that waits";
  EXPECT_EQ(axis.run(200).position, 0);
}

// A start that was missed, by ticks or within one, has passed points on its way: none is left out.
TEST(AxisCoincidence, ACompareMissesNoPointOfALateStart) {
  const PositionCompare points{
      .mode = CompareMode::linear, .points = evenly(0.5, 1, 20), .pulse = 2e-4};
  const TablePtr table = trapezoid_table(30, 100, 1000, 1000);
  Job job(1, table);
  Bench axis({.limits = limits(1e3, 1e5)});
  axis.axis = MotionAxis({.limits = limits(1e3, 1e5)}, {}, {SwitchesOf::position, points});
  axis.send(Kind::enable);
  axis.arm(job);
  axis.step({command::Start{.tick = 40}});
  axis.run(36);
  ASSERT_EQ(axis.tick, 38);
  axis.tick = 79;  // 40 ticks of it are over: 0.8 u
  std::size_t edges = axis.step().compare.edges().size();
  while (axis.tick < 600) edges += axis.step().compare.edges().size();
  EXPECT_EQ(edges, 40U);
}

}  // namespace
}  // namespace jounce::axis_coincidence_test
