// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <memory>

#include <gtest/gtest.h>

#include "jounce/axis/axis.hpp"
#include "jounce/axis/fifo_movement.hpp"
#include "jounce/axis/job.hpp"

#include "axis/model/model_movements.hpp"
#include "axis/tables.hpp"
#include "support/loop_limit.hpp"

namespace jounce::axis_faults_test {
namespace {

using namespace test;

AxisConfig ranged(double low, double high) {
  AxisConfig config{.limits = limits(100, 1000)};
  config.limits.position_min = low;
  config.limits.position_max = high;
  return config;
}

Inputs drive_at(double position) {
  Inputs inputs;
  inputs.feedback.position = position;
  return inputs;
}

/// In velocity, 100 u/s, after that many ticks.
Tick cruise(Bench& bench, std::int64_t ticks = 200, double direction = 1) {
  bench.send(Kind::enable);
  bench.step({command::MoveVelocity{.velocity = direction * 100}});
  return bench.run(ticks);
}

// Googol example 9-1 in small: it stops before the limit, not behind it.
TEST(AxisFaults, AVelocityMoveStopsBeforeTheSoftLimit) {
  for (const double direction : {1.0, -1.0}) {
    Bench bench(ranged(-50, 50));
    cruise(bench, 10, direction);
    Tick tick = bench.step();
    for (test::LoopLimit loop; tick.fault == Cause::none && loop.goes_on();) tick = bench.step();
    EXPECT_EQ(tick.fault, direction > 0 ? Cause::positive_soft_limit : Cause::negative_soft_limit);
    EXPECT_EQ(tick.state, State::error_stop);
    EXPECT_NE(tick.velocity, 0);
    EXPECT_EQ(refusal(bench.send(Kind::reset)), Cause::in_motion);
    tick = bench.run(100);
    EXPECT_EQ(tick.velocity, 0);
    EXPECT_LE(std::abs(tick.position), 50 + 1e-9);
    EXPECT_GT(std::abs(tick.position), 50 - 0.1 - 1e-9);  // a tick's way at most
    EXPECT_EQ(tick.reason, tick.fault);
    EXPECT_EQ(bench.send(Kind::reset).state, State::standstill);
    EXPECT_EQ(bench.step({command::MoveAbsolute{.position = 0}}).state, State::discrete_motion);
  }
}

TEST(AxisFaults, ALimitSwitchStopsAndBlocksItsDirection) {
  Bench bench(ranged(-500, 500));
  const Tick before = cruise(bench);
  Inputs on;
  on.positive_switch = true;
  Tick tick = bench.step({}, on);
  EXPECT_EQ(tick.fault, Cause::positive_switch);
  EXPECT_NEAR(tick.velocity, before.velocity - 2, 1e-9);  // stop_acceleration, 2000 u/s^2
  for (test::LoopLimit loop; tick.velocity != 0 && loop.goes_on();) tick = bench.step({}, on);
  bench.step({command::Reset{}}, on);
  const auto move = [&](double distance) {
    return refusal(bench.step({command::MoveRelative{.distance = distance}}, on));
  };
  EXPECT_EQ(move(1), Cause::direction_blocked);
  EXPECT_EQ(refusal(bench.step({command::MoveVelocity{.velocity = 1}}, on)),
            Cause::direction_blocked);
  EXPECT_EQ(move(-1), Cause::none);
}

// A path that leads outwards from an active switch is refused where it starts; it would fault in its second tick.
TEST(AxisFaults, NoPathStartsOntoAnActiveLimitSwitch) {
  const auto rows = [](double distance) {
    auto path = std::make_unique<FifoPath>(2, FifoSpec{.each = 8, .range = {-20, 20}});
    path->fifos().push(0, {.x_end = 1, .p_end = 0, .v_start = 0, .v_end = 0, .degree = 3});
    path->fifos().push(
        0, {.x_end = 2, .p_end = distance, .v_start = 0, .v_end = 0, .degree = 3, .last = true});
    return path;
  };
  const auto dwell_first = [](double distance) {
    return std::make_unique<Job>(
        1, table(Domain::time, Interpolation::cubic_hermite, Extrapolation::hold,
                 {{0, 1, 2, 3}, {0, 0, distance, 0}, {0, 0, 0, 0}, {}}));
  };
  for (const double way : {1.0, -1.0})
    for (const bool outwards : {true, false})
      for (const bool pushed : {true, false}) {
        SCOPED_TRACE(testing::Message() << way << (outwards ? " outwards" : " inwards")
                                        << (pushed ? ", rows" : ", a table"));
        Bench bench(ranged(-500, 500));
        bench.send(Kind::enable);
        Inputs on;
        (way > 0 ? on.positive_switch : on.negative_switch) = true;
        const double distance = outwards ? 10 * way : -10 * way;
        const std::unique_ptr<Movement> path =
            pushed ? std::unique_ptr<Movement>(rows(distance)) : dwell_first(distance);
        EXPECT_EQ(refusal(bench.step({command::Arm{.movement = path.get()}}, on)), Cause::none);
        const Tick tick = bench.step({command::Start{}}, on);
        EXPECT_EQ(refusal(tick), outwards ? Cause::direction_blocked : Cause::none);
        EXPECT_EQ(tick.state, outwards ? State::standstill : State::discrete_motion);
        // The switch goes on between the acceptance of a start and the start.
        if (!outwards) continue;
        bench.step({command::Start{.tick = bench.tick + 5}});
        for (int i = 0; i < 3; ++i) bench.step();
        const Tick late = bench.step({}, on);
        ASSERT_TRUE(late.dropped.has_value());
        EXPECT_EQ(late.dropped->cause, Cause::direction_blocked);
      }
}

TEST(AxisFaults, TheFollowingErrorHasAWindowOfTime) {
  AxisConfig config = ranged(-500, 500);
  config.following_error = 2;
  config.following_time = 0.01;
  Bench bench(config);
  bench.step({}, drive_at(0));
  bench.step({command::Enable{}}, drive_at(0));
  for (int i = 0; i < 9; ++i) EXPECT_EQ(bench.step({}, drive_at(2.5)).fault, Cause::none);
  EXPECT_EQ(bench.step({}, drive_at(1.5)).fault, Cause::none) << "back in time";
  Tick tick;
  for (int i = 0; i < 10; ++i) tick = bench.step({}, drive_at(-2.5));
  EXPECT_EQ(tick.fault, Cause::following_error);
  EXPECT_EQ(tick.state, State::disabled);
  EXPECT_FALSE(tick.power);
  // Switched off, the axis is where the drive is; enabled again, it is there still, in its fault.
  EXPECT_EQ(bench.step({}, drive_at(-2.6)).position, -2.6);
  tick = bench.step({command::Enable{}}, drive_at(-2.6));
  EXPECT_EQ(tick.state, State::error_stop);
  EXPECT_EQ(tick.position, -2.6);
}

TEST(AxisFaults, EnablingWaitsForTheDrive) {
  Bench bench(ranged(-500, 500));
  Inputs off;
  off.feedback.ready = false;
  EXPECT_TRUE(bench.step({command::Enable{}}, off).power);
  EXPECT_EQ(bench.step({}, off).state, State::disabled);
  EXPECT_EQ(bench.step().state, State::standstill);
  EXPECT_EQ(bench.step({}, off).fault, Cause::drive_not_ready);
  EXPECT_FALSE(bench.step({}, off).power);
}

TEST(AxisFaults, ADriveFaultSwitchesOffAndKeepsItFromBeingEnabled) {
  Bench bench(ranged(-500, 500));
  cruise(bench);
  Inputs broken;
  broken.feedback.fault = true;
  const Tick tick = bench.step({}, broken);
  EXPECT_EQ(tick.fault, Cause::drive_fault);
  EXPECT_EQ(tick.state, State::disabled);
  EXPECT_EQ(tick.velocity, 0);
  EXPECT_EQ(refusal(bench.step({command::Enable{}}, broken)), Cause::drive_fault);
}

TEST(AxisFaults, TheWatchdogStopsOnThePathAndIsNoFaultAtRest) {
  Job job(1, trapezoid_table(50, 10, 20, 20));
  Bench bench({.limits = limits(10, 20)});
  Inputs silent;
  silent.watchdog = true;
  bench.send(Kind::enable);
  EXPECT_EQ(bench.step({}, silent).fault, Cause::none);
  bench.arm(job);
  bench.send(Kind::start);
  const double from = bench.run(1000).position;
  Tick tick = bench.step({}, silent);
  EXPECT_EQ(tick.fault, Cause::watchdog);
  EXPECT_EQ(tick.state, State::error_stop);
  EXPECT_EQ(tick.job, 1U);
  for (test::LoopLimit loop; tick.job != 0 && loop.goes_on();) tick = bench.step({}, silent);
  EXPECT_NEAR(tick.position, from + 0.01 + 3.75, 1e-9);  // same distance as a stop: axis_test.cpp
  EXPECT_EQ(tick.velocity, 0);
  EXPECT_EQ(tick.state, State::error_stop);
}

TEST(AxisFaults, AnAbortMayHaveADeceleration) {
  AxisConfig config = ranged(-500, 500);
  config.abort_acceleration = 10'000;
  Bench bench(config);
  const Tick before = cruise(bench);
  Tick tick = bench.send(Kind::abort);
  EXPECT_EQ(tick.fault, Cause::aborted);
  EXPECT_NEAR(tick.velocity, 90, 1e-9);
  tick = bench.run(9);
  EXPECT_NEAR(tick.velocity, 0, 1e-9);
  EXPECT_NEAR(tick.position - before.position, 0.5, 1e-9);
}

// A rolling stream that dries up: the stop ends before what is known does, on the path; when more
// has come it goes on from there.
TEST(AxisFaults, AnUnderrunStopsOnThePathAndResumes) {
  Feed feed(1, 0, 5, 10);  // 50 u/s, 500 u/s^2
  feed.prefill(1);
  Bench bench({.limits = limits(100, 1000)});
  bench.send(Kind::enable);
  bench.step({command::Arm{.movement = &feed}});
  Tick tick = bench.send(Kind::start);
  const auto on_path = [&](double p) { return p >= 0 && p <= 10; };
  for (test::LoopLimit loop; tick.fault == Cause::none && loop.goes_on();) tick = bench.step();
  EXPECT_EQ(tick.fault, Cause::underrun);
  EXPECT_EQ(tick.state, State::error_stop);
  for (test::LoopLimit loop; tick.velocity != 0 && loop.goes_on();) {
    tick = bench.step();
    ASSERT_TRUE(on_path(tick.position));
  }
  const double rest = tick.position;
  // 1 s of path was known; of path time all but a stop's way (D/2) and two ticks had been used.
  const double D = 1.5 * 50 / (2000 - 500);
  EXPECT_NEAR(rest, 5 * (1 - std::cos(10.0)), 50 * 3e-3);
  EXPECT_EQ(tick.job, 1U);
  EXPECT_EQ(bench.run(500).position, rest);
  EXPECT_LT(D / 2, 0.05);

  feed.supply = 2e-3;
  bench.run(100);
  tick = bench.send(Kind::reset);
  EXPECT_EQ(tick.fault, Cause::none);
  EXPECT_EQ(tick.state, State::discrete_motion);
  EXPECT_EQ(bench.run(10).position, rest) << "held until resume";
  bench.send(Kind::resume);
  tick = bench.run(300);
  EXPECT_EQ(tick.rate, 1);
  EXPECT_EQ(tick.fault, Cause::none);
}

// At twice the speed a stop has less to brake with than at once: 2000 of 22000 u/s^2 beside the
// path's own. An axis on its way to the higher rate still stops in time.
TEST(AxisFaults, AnUnderrunOnTheWayToAHigherRateStopsOnThePathToo) {
  for (const double known : {0.2, 0.3, 0.4, 0.5}) {
    Feed feed(1, 0, 12.5, 20);  // 250 u/s, 5000 u/s^2
    feed.prefill(known);
    AxisConfig config{.limits = limits(500, 2e4)};
    config.stop_acceleration = 2.2e4;
    Bench bench(config);
    bench.send(Kind::enable);
    bench.step({command::Arm{.movement = &feed}});
    bench.send(Kind::start);
    bench.run(50);
    const double granted = bench.step({command::Override{.factor = 2}}).override_;
    EXPECT_TRUE(granted >= 1 && granted <= 2) << "what is known allows: " << granted;
    Tick tick = bench.run(1000);
    EXPECT_EQ(tick.fault, Cause::underrun);
    EXPECT_EQ(tick.job, 1U) << "still on its path, " << known << " s of which were known";
    EXPECT_EQ(tick.progress, Progress::starving);
    EXPECT_EQ(tick.rate, 0);
    EXPECT_FALSE(in_motion(tick));
  }
}

TEST(AxisFaults, AMasterThatIsLostOrLeapsIsBrakedFrom) {
  for (const bool lost : {true, false}) {
    Gear gear(1, 1);
    Bench bench({.limits = limits(100, 1000)});
    bench.send(Kind::enable);
    Inputs inputs;
    inputs.master = {0, 0, 0, 0};
    bench.step({command::Couple{.movement = &gear}}, inputs);
    Tick tick;
    for (int k = 1; k <= 50; ++k) {
      inputs.master = {k * k * 0.5e-3, k * 1.0, 1000, 0};
      tick = bench.step({}, inputs);
    }
    ASSERT_EQ(tick.velocity, 50);
    const double p = tick.position;
    inputs.master = {lost ? NAN : 100, 50, 0, 0};
    tick = bench.step({}, inputs);
    EXPECT_EQ(tick.fault, lost ? Cause::master_lost : Cause::overspeed);
    EXPECT_NEAR(tick.velocity, 48, 1e-9);
    EXPECT_NEAR(tick.position - p, 0.049, 1e-9);
    tick = bench.run(25);
    EXPECT_EQ(tick.velocity, 0);
    EXPECT_NEAR(tick.position - p, 50 * 50 / 4000.0, 1e-9);
  }
}

TEST(AxisFaults, InPositionNeedsTheBandAndItsTime) {
  AxisConfig config = ranged(-500, 500);
  config.in_position = 0.1;
  config.in_position_time = 0.005;
  Bench bench(config);
  bench.step({}, drive_at(0));
  bench.step({command::Enable{}}, drive_at(0));
  for (int i = 0; i < 3; ++i) EXPECT_FALSE(bench.step({}, drive_at(0.05)).in_position);
  EXPECT_TRUE(bench.step({}, drive_at(0.05)).in_position);
  EXPECT_FALSE(bench.step({}, drive_at(0.2)).in_position) << "at once";
  for (int i = 0; i < 5; ++i) bench.step({}, drive_at(0.05));
  EXPECT_TRUE(bench.step({}, drive_at(0)).in_position);
  EXPECT_FALSE(bench.step({command::MoveRelative{.distance = 1}}, drive_at(0)).in_position);
}

}  // namespace
}  // namespace jounce::axis_faults_test
