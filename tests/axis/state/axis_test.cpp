// SPDX-License-Identifier: Apache-2.0
#include "jounce/axis/axis.hpp"

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "axis/tables.hpp"
#include "support/loop_limit.hpp"

namespace jounce::axis_test {
namespace {

using namespace test;

const AxisConfig wide{.limits = limits(1e5, 1e8)};

bool handed_back(const Tick& tick, Job& job) {
  return std::count(tick.handed_back.begin(), tick.handed_back.end(), &job) == 1;
}

TEST(MotionAxis, NothingMovesBeforeEnableArmAndStart) {
  Job job(7, trapezoid_table(100, 50, 100, 100));
  Bench bench(wide);
  EXPECT_EQ(bench.step().state, State::disabled);
  EXPECT_EQ(refusal(bench.arm(job)), Cause::not_enabled);
  EXPECT_EQ(refusal(bench.send(Kind::start)), Cause::not_enabled);
  EXPECT_EQ(bench.send(Kind::enable).state, State::standstill);
  EXPECT_EQ(refusal(bench.send(Kind::start)), Cause::not_armed);
  const Tick armed = bench.arm(job);
  EXPECT_EQ(armed.armed, 7U);
  EXPECT_EQ(armed.job, 0U);
  EXPECT_EQ(bench.run(50).position, 0);
  const Tick first = bench.send(Kind::start);
  EXPECT_EQ(first.state, State::discrete_motion);
  EXPECT_EQ(first.job, 7U);
  EXPECT_EQ(first.armed, 0U);
  EXPECT_EQ(first.position, 0);
  EXPECT_GT(bench.step().position, 0);
}

// Googol GTS manual example 7-1: 50000 pulses, 50 pulse/ms, 0.25 and 0.125 pulse/ms^2: 200 ms up,
// 700 ms at speed, 400 ms down.
TEST(MotionAxis, GoogolTrapezoidTakes1300Ticks) {
  Job job(1, trapezoid_table(50000, 50e3, 0.25e6, 0.125e6));
  Bench bench({.limits = limits(50e3, 0.25e6)});
  bench.play(job);
  const auto at = [&](std::int64_t ms) { return bench.run(ms - (bench.tick - 2)); };
  EXPECT_NEAR(at(100).position, 0.25 * 100 * 100 / 2, 1e-9);
  EXPECT_NEAR(at(200).position, 5000, 1e-9);
  EXPECT_NEAR(at(550).velocity, 50e3, 1e-6);
  EXPECT_NEAR(at(900).position, 40000, 1e-8);
  const Tick before = at(1299);
  EXPECT_EQ(before.state, State::discrete_motion);
  EXPECT_NEAR(before.position, 50000 - 0.125 / 2, 1e-8);
  EXPECT_NEAR(before.acceleration, -0.125e6, 1e-3);
  const Tick end = bench.step();
  EXPECT_EQ(end.state, State::standstill);
  EXPECT_EQ(end.position, 50000);
  EXPECT_EQ(end.velocity, 0);
  EXPECT_EQ(end.acceleration, 0);
  EXPECT_EQ(end.finished, 1U);
  EXPECT_TRUE(handed_back(end, job));
  EXPECT_EQ(bench.run(100).position, 50000);
}

TEST(MotionAxis, EverySetpointIsTheTablesBitForBit) {
  const TablePtr move = table(Domain::time, Interpolation::quintic_hermite, Extrapolation::hold,
                              {{0, 0.1, 0.37, 0.6}, {0, 3, 1, 2}, {0, 9, -4, 0}, {0, 7, 2, 0}});
  Job job(1, move);
  Bench bench(wide);
  Tick tick = bench.play(job);
  for (std::int64_t k = 0; k < 600; ++k, tick = bench.step()) {
    const Jet exact = move->jet(static_cast<double>(k * 1'000'000) / 1e9);
    ASSERT_EQ(tick.position, exact[0]) << k;
    ASSERT_EQ(tick.velocity, exact[1]) << k;
    ASSERT_EQ(tick.acceleration, exact[2]) << k;
    ASSERT_EQ(tick.time, static_cast<double>((k + 2) * 1'000'000) / 1e9);
  }
  EXPECT_EQ(tick.state, State::standstill);
}

// PMC600 manual 6.2, example 4.3: Fig. 6.14 at 200 pulse/s for 1080 pulses, three periods of 1.8 s.
TEST(MotionAxis, Example43RunsThreeEqualPeriods) {
  const TablePtr cam = pmc600_cam();
  const TablePtr master = constant_master(1080, 200);
  Job job(3, master, cam);
  Bench bench({.limits = limits(700, 7000)});
  std::vector<Tick> ticks{bench.play(job)};
  EXPECT_EQ(ticks[0].state, State::synchronized_motion);
  for (test::LoopLimit loop; ticks.back().state == State::synchronized_motion && loop.goes_on();)
    ticks.push_back(bench.step());
  ASSERT_EQ(ticks.size(), 5401U);  // 5.4 s

  for (std::size_t k = 0; k < 5400; ++k) {
    const Jet m = master->jet(static_cast<double>(k * 1'000'000) / 1e9);
    ASSERT_EQ(ticks[k].master, m[0]);
    ASSERT_EQ(ticks[k].position, cam->jet(m[0])[0]);
    ASSERT_EQ(ticks[k].velocity, cam->jet(m[0])[1] * m[1]);
  }
  // In sync from master 75 to 200 in each period: the slave at 200 pulse/s, 25 pulses ahead.
  for (std::size_t k = 0; k < 1800; ++k) {
    const Tick& tick = ticks[k];
    if (tick.master > 75 && tick.master < 200) {
      ASSERT_NEAR(tick.velocity, 200, 1e-9);
      ASSERT_NEAR(tick.position, tick.master + 25, 1e-9);
    }
    for (const std::size_t period : {1800U, 3600U})
      ASSERT_NEAR(ticks[k + period].position, tick.position, 1e-9) << k;
  }
  EXPECT_EQ(ticks.back().state, State::standstill);
  EXPECT_NEAR(ticks.back().position, 0, 1e-9);
  EXPECT_EQ(ticks.back().master, 1080);
  EXPECT_EQ(ticks.back().master_velocity, 0);
}

// PMC600 manual 6.2, example 4.4, on an axis that can take the kink: see admit_test.cpp.
TEST(MotionAxis, Example44FollowsBothLinesAndLeavesTheMaster) {
  const TablePtr cam = table(Domain::master, Interpolation::linear, Extrapolation::hold,
                             {{0, 5000, 10000}, {0, 5000, 7000}, {}, {}});
  Job job(4, trapezoid_table(10000, 10000, 1e5, 1e5), cam);
  Bench bench({.limits = limits(1e4, 6e6)});
  Tick tick = bench.play(job);
  int at_10000 = 0;
  int at_4000 = 0;
  for (; tick.state == State::synchronized_motion; tick = bench.step()) {
    ASSERT_NEAR(tick.position, tick.master < 5000 ? tick.master : 3000 + 0.4 * tick.master, 1e-9);
    at_10000 += std::abs(tick.velocity - 10000) < 1e-6;
    at_4000 += std::abs(tick.velocity - 4000) < 1e-6 && tick.master > 5000;
  }
  // 4500 pulses at 10000 pulse/s on either side of the kink; which side counts the tick that falls
  // on a joint is a matter of rounding.
  EXPECT_NEAR(at_10000, 450, 1);
  EXPECT_NEAR(at_4000, 450, 1);
  EXPECT_EQ(tick.state, State::standstill);
  EXPECT_NEAR(tick.position, 7000, 1e-9);
}

// PMC600 manual Fig. 5.13, a PT table: stages of 10000, 40000, -10000 and -5000 pulses.
TEST(MotionAxis, PmcPositionTableReachesItsKnots) {
  Job job(5, table(Domain::time, Interpolation::linear, Extrapolation::hold,
                   {{0, 1, 3, 4, 4.5}, {0, 10000, 50000, 40000, 35000}, {}, {}}));
  Bench bench({.limits = limits(20000, 3e7)});
  bench.play(job);
  EXPECT_EQ(bench.run(500).position, 5000);
  EXPECT_EQ(bench.run(500).position, 10000);
  EXPECT_EQ(bench.run(2000).position, 50000);
  EXPECT_EQ(bench.run(1000).position, 40000);
  const Tick end = bench.run(500);
  EXPECT_EQ(end.position, 35000);
  EXPECT_EQ(end.state, State::standstill);
}

// ---- stop --------------------------------------------------------------------------------------

TEST(MotionAxis, StopFollowsTheClosedFormOfItsRamp) {
  // At 10 u/s on a line with v = 10 and A = 20, stop acceleration 40: the rate falls by at most
  // R = (40 - 20) / 10 = 2 /s, and by 2 R^2 = 8 /s^2 to that, so D = 3 / (2R) = 0.75 s in thirds,
  // the way 10 * D/2 = 3.75, the velocity halved at D/2, the deepest deceleration 10 R = 20 there.
  // Path time at D/2: 0.25 - 8 * 0.25^3 / 6, and 0.125 s from the rate 0.75 at -2 /s.
  Job job(1, trapezoid_table(50, 10, 20, 20));
  Bench bench({.limits = limits(10, 20)});
  bench.play(job);
  const double from = bench.run(1000).position;
  const Tick stop = bench.send(Kind::stop);
  EXPECT_EQ(stop.state, State::stopping);
  EXPECT_NEAR(stop.position, from + 0.01, 1e-12);
  EXPECT_NEAR(stop.velocity, 10, 1e-12);
  const Tick half = bench.run(375);
  EXPECT_NEAR(half.velocity, 5, 1e-12);
  EXPECT_NEAR(half.acceleration, -20, 1e-12);
  EXPECT_NEAR(half.position,
              stop.position + 10 * (0.25 - 8 * 0.015625 / 6 + 0.75 * 0.125 - 0.015625), 1e-12);
  const Tick last = bench.run(374);
  EXPECT_EQ(last.state, State::stopping);
  EXPECT_GT(last.velocity, 0);
  const Tick rest = bench.step();
  EXPECT_EQ(rest.state, State::standstill);
  EXPECT_NEAR(rest.position, stop.position + 3.75, 1e-12);
  EXPECT_EQ(rest.velocity, 0);
  EXPECT_EQ(rest.stopped, 1U);
  EXPECT_EQ(rest.finished, 0U);
  EXPECT_TRUE(handed_back(rest, job));
}

TEST(MotionAxis, StopStaysOnTheCamAndWithinTheStopLimits) {
  const TablePtr cam = pmc600_cam();
  Job job(1, trapezoid_table(1080, 200, 1000, 1000), cam);
  const double a = std::abs(job.ranges()[2].peak().value);  // the table uses the limit up
  const AxisConfig config{.limits = limits(700, a)};
  for (std::int64_t when = 0; when < 5600; when += 97) {
    Bench bench(config);
    std::vector<Tick> ticks{bench.play(job)};
    for (std::int64_t k = 1; k < when; ++k) ticks.push_back(bench.step());
    ticks.push_back(bench.send(Kind::stop));
    for (test::LoopLimit loop; ticks.back().state == State::stopping && loop.goes_on();)
      ticks.push_back(bench.step());
    ticks.push_back(bench.step());
    ASSERT_EQ(ticks.back().state, State::standstill);
    for (std::size_t i = 0; i < ticks.size(); ++i) {
      ASSERT_NEAR(ticks[i].position, cam->jet(ticks[i].master)[0], 1e-9) << when;
      if (i < 2) continue;
      // The drive sees the second difference, a mean of the acceleration over two ticks.
      const double seen =
          (ticks[i].position - 2 * ticks[i - 1].position + ticks[i - 2].position) * 1e6;
      ASSERT_LE(std::abs(seen), 2 * a * (1 + 1e-9)) << when << " + " << i;
    }
  }
}

TEST(MotionAxis, StopWithAJerkLimitKeepsTheStopJerk) {
  Job job(1, there_and_back(0, 50, 2, Extrapolation::hold));
  const double jerk = 60 * 50;  // 60 h / T^3, T = 1 s each way
  const AxisConfig config{.limits = limits(100, 400, jerk)};
  for (std::int64_t when = 100; when < 2000; when += 130) {
    Bench bench(config);
    bench.play(job);
    std::vector<Tick> ticks{bench.run(when)};
    ticks.push_back(bench.send(Kind::stop));
    for (test::LoopLimit loop; ticks.back().state == State::stopping && loop.goes_on();)
      ticks.push_back(bench.step());
    for (std::size_t i = 1; i < ticks.size(); ++i) {
      const double seen = (ticks[i].acceleration - ticks[i - 1].acceleration) * 1000;
      ASSERT_LE(std::abs(seen), 2 * jerk * (1 + 1e-9)) << when << " + " << i;
    }
  }
}

TEST(MotionAxis, StopNearTheEndLetsTheTableEnd) {
  Job job(1, trapezoid_table(50, 10, 20, 20));
  Bench bench({.limits = limits(10, 20)});
  bench.play(job);
  bench.run(5490);  // 10 of the 5500 ticks are left
  bench.send(Kind::stop);
  const Tick end = bench.run(750);
  EXPECT_EQ(end.state, State::standstill);
  EXPECT_EQ(end.position, 50);
  EXPECT_EQ(end.stopped, 1U);
}

TEST(MotionAxis, ASecondStopChangesNothing) {
  Job job(1, trapezoid_table(50, 10, 20, 20));
  Bench once({.limits = limits(10, 20)});
  Bench twice({.limits = limits(10, 20)});
  for (Bench* bench : {&once, &twice}) {
    bench->play(job);
    bench->run(1000);
    bench->send(Kind::stop);
    bench->run(100);
  }
  once.step();
  twice.send(Kind::stop);
  EXPECT_EQ(once.run(900).position, twice.run(900).position);
}

TEST(MotionAxis, ARepeatingTableRunsUntilItIsStopped) {
  const TablePtr cycle = there_and_back(0, 10, 0.5, Extrapolation::wrap);
  Job job(1, cycle);
  Bench bench(wide);
  bench.play(job);
  EXPECT_NEAR(bench.run(250).position, 10, 1e-12);
  EXPECT_NEAR(bench.run(10'000).position, 10, 1e-9);
  EXPECT_EQ(bench.axis.state(), State::discrete_motion);
  Job next(2, cycle);
  EXPECT_EQ(refusal(bench.arm(next)), Cause::none);  // for a swap: it begins where this one closes
  EXPECT_EQ(refusal(bench.send(Kind::start)), Cause::in_motion);
  bench.send(Kind::stop);
  bench.run(1000);
  EXPECT_EQ(bench.axis.state(), State::standstill);
}

// ---- faults ------------------------------------------------------------------------------------

TEST(MotionAxis, AbortFreezesAndLatchesUntilReset) {
  Job job(1, trapezoid_table(50, 10, 20, 20));
  Job next(2, trapezoid_table(50, 10, 20, 20));
  Bench bench({.limits = limits(10, 20)});
  bench.play(job);
  const double before = bench.run(1000).position;
  const Tick aborted = bench.send(Kind::abort);
  EXPECT_EQ(aborted.state, State::error_stop);
  EXPECT_EQ(aborted.fault, Cause::aborted);
  EXPECT_EQ(aborted.position, before);
  EXPECT_EQ(aborted.velocity, 0);
  EXPECT_TRUE(handed_back(aborted, job));
  for (const Kind kind : {Kind::start, Kind::stop}) {
    EXPECT_EQ(refusal(bench.send(kind)), Cause::in_error);
  }
  const Tick refused = bench.arm(next);
  EXPECT_EQ(refusal(refused), Cause::in_error);
  EXPECT_TRUE(handed_back(refused, next));
  EXPECT_EQ(bench.run(100).fault, Cause::aborted);
  EXPECT_EQ(bench.send(Kind::reset).state, State::standstill);
  EXPECT_EQ(bench.step().fault, Cause::none);
  EXPECT_EQ(bench.step().position, before);
  EXPECT_EQ(refusal(bench.arm(next)), Cause::start_position);  // it stands in mid-path
  EXPECT_EQ(refusal(bench.step({command::SetPosition{.position = 0}})), Cause::none);
  EXPECT_EQ(refusal(bench.arm(next)), Cause::none);
}

TEST(MotionAxis, DisablingInMotionIsAFaultThatEnableComesBackTo) {
  Job job(1, trapezoid_table(50, 10, 20, 20));
  Bench bench({.limits = limits(10, 20)});
  bench.play(job);
  bench.run(1000);
  Tick tick = bench.send(Kind::disable);
  EXPECT_EQ(tick.state, State::disabled);
  EXPECT_EQ(tick.fault, Cause::disabled_in_motion);
  EXPECT_EQ(tick.velocity, 0);
  tick = bench.send(Kind::enable);
  EXPECT_EQ(tick.state, State::error_stop);
  tick = bench.send(Kind::reset);
  EXPECT_EQ(tick.state, State::standstill);
  EXPECT_EQ(tick.fault, Cause::none);
}

// The guard in motion detects a table in memory that is no longer the admitted one.
TEST(MotionAxis, ASetpointThatNoAdmittedTableCanAskForIsAFault) {
  AxisConfig config{.limits = limits(10, 20)};
  config.limits.position_max = 60;
  const auto fault = [&](const TablePtr& other) {
    const auto table = std::make_shared<Table>(*trapezoid_table(50, 10, 20, 20));
    Job job(1, table);
    Bench bench(config);
    bench.play(job);
    const double before = bench.run(1000).position;
    *table = *other;
    Tick tick = bench.step();
    for (test::LoopLimit loop; tick.state == State::discrete_motion && loop.goes_on();)
      tick = bench.step();
    EXPECT_EQ(tick.state, State::error_stop);
    EXPECT_GE(tick.position, before);
    const double good = tick.position;
    // no leap: it brakes with 40 u/s^2 from 10 u/s
    for (test::LoopLimit loop; tick.velocity != 0 && loop.goes_on();) {
      const Tick next = bench.step();
      EXPECT_EQ(next.state, State::error_stop);
      EXPECT_NEAR(next.velocity, std::max(tick.velocity - 0.04, 0.0), 1e-9);
      tick = next;
    }
    EXPECT_NEAR(tick.position - good, 10 * 10 / 80.0, 0.02);
    return std::pair(tick.fault, good);
  };
  const auto jumped = fault(trapezoid_table(100, 20, 40, 40));
  EXPECT_EQ(jumped.first, Cause::overspeed);
  EXPECT_NEAR(jumped.second, 7.51, 1e-3);  // from where it was: 2.5 u of ramp, 0.5 s at 10 u/s
  const auto left = fault(trapezoid_table(100, 10, 20, 20));
  EXPECT_EQ(left.first, Cause::out_of_range);
  EXPECT_NEAR(left.second, 60, 0.02);
}

TEST(MotionAxis, TheFirstFaultStays) {
  Job job(1, trapezoid_table(50, 10, 20, 20));
  Bench bench({.limits = limits(10, 20)});
  bench.play(job);
  bench.run(100);
  bench.send(Kind::disable);
  EXPECT_EQ(bench.send(Kind::abort).fault, Cause::disabled_in_motion);
}

// ---- late cycles -------------------------------------------------------------------------------

TEST(MotionAxis, SkippedTicksAreLeftOutOfTheMotion) {
  const TablePtr move = trapezoid_table(50, 10, 20, 20);
  Job job(1, move);
  MotionAxis axis({.limits = limits(10, 20)});
  axis.step(0, {command::Enable{}});
  axis.step(1, {command::Arm{.movement = &job}});
  axis.step(2, {command::Start{}});
  axis.step(1000);  // 998 ticks late on the first: beyond the default gap
  EXPECT_EQ(axis.state(), State::error_stop);

  axis.step(1001, {command::Reset{}});
  EXPECT_EQ(refusal(axis.step(1002, {command::Arm{.movement = &job}})), Cause::none);
  axis.step(1003, {command::Start{}});
  const Tick late = axis.step(1053);
  EXPECT_EQ(late.skipped, 49);
  EXPECT_EQ(late.position, move->jet(0.05)[0]);
  EXPECT_EQ(axis.step(1153).position, move->jet(0.15)[0]);  // 99 skipped
  const Tick stalled = axis.step(1254);                     // 100 skipped
  EXPECT_EQ(stalled.fault, Cause::stalled);
  EXPECT_EQ(stalled.position, move->jet(0.15)[0]);
}

TEST(MotionAxis, AStartAtALaterTickBeginsExactlyThere) {
  const TablePtr move = trapezoid_table(50, 10, 20, 20);
  Job job(9, move);
  Bench bench(wide);
  bench.send(Kind::enable);
  bench.arm(job);
  Tick tick = bench.step({command::Start{.tick = 10}});
  EXPECT_EQ(tick.state, State::standstill);
  EXPECT_TRUE(tick.waiting);
  tick = bench.axis.step(9);
  EXPECT_TRUE(tick.waiting);
  EXPECT_EQ(tick.armed, 9U);
  tick = bench.axis.step(13);  // late by three: local time runs from tick 10 all the same
  EXPECT_FALSE(tick.waiting);
  EXPECT_EQ(tick.position, move->jet(0.003)[0]);

  Bench other(wide);
  other.send(Kind::enable);
  other.run(5);
  other.arm(job);
  tick = other.step({command::Start{.tick = 3}});
  EXPECT_EQ(refusal(tick), Cause::too_late);
  EXPECT_EQ(tick.refused->value, 3);
}

TEST(MotionAxis, StopOrDisableTakesBackAWaitingStart) {
  Job job(9, trapezoid_table(50, 10, 20, 20));
  for (const Kind kind : {Kind::stop, Kind::disable}) {
    Bench bench(wide);
    bench.send(Kind::enable);
    bench.arm(job);
    bench.step({command::Start{.tick = 10}});
    const Tick tick = bench.send(kind);
    EXPECT_FALSE(tick.waiting);
    EXPECT_TRUE(handed_back(tick, job));
    EXPECT_EQ(bench.run(50).position, 0);
    EXPECT_EQ(bench.step().fault, Cause::none);
  }
}

TEST(MotionAxis, DisarmRemovesAMotionThatWasNotStarted) {
  Job job(9, trapezoid_table(50, 10, 20, 20));
  Bench bench(wide);
  bench.send(Kind::enable);
  bench.arm(job);
  EXPECT_TRUE(handed_back(bench.send(Kind::disarm), job));
  EXPECT_EQ(refusal(bench.send(Kind::start)), Cause::not_armed);
  bench.arm(job);
  bench.step({command::Start{.tick = 10}});
  EXPECT_TRUE(bench.send(Kind::disarm).waiting);
  EXPECT_EQ(bench.run(10).state, State::discrete_motion);
}

// ---- slots -------------------------------------------------------------------------------------

TEST(MotionAxis, TablesAreSwappedAtStandstill) {
  Job out(1, trapezoid_table(50, 10, 20, 20));
  Job back(2, table(Domain::time, Interpolation::quintic_hermite, Extrapolation::hold,
                    {{0, 10}, {50, 0}, {0, 0}, {0, 0}}));
  Job wrong(3, trapezoid_table(50, 10, 20, 20));
  Bench bench({.limits = limits(10, 20)});
  bench.play(out);
  bench.run(100);
  // Armed in motion against the position where the motion will end.
  Tick tick = bench.arm(wrong);
  EXPECT_EQ(refusal(tick), Cause::start_position);
  EXPECT_EQ(tick.refused->limit, 50);
  EXPECT_EQ(refusal(bench.arm(back)), Cause::none);
  EXPECT_EQ(refusal(bench.send(Kind::start)), Cause::in_motion);
  tick = bench.run(5500);
  EXPECT_EQ(tick.state, State::standstill);
  EXPECT_EQ(tick.armed, 2U);
  bench.send(Kind::start);
  tick = bench.run(10000);
  EXPECT_EQ(tick.state, State::standstill);
  EXPECT_EQ(tick.position, 0);
  EXPECT_EQ(tick.finished, 2U);
}

TEST(MotionAxis, ArmingAgainHandsTheFirstJobBack) {
  Job first(1, trapezoid_table(50, 10, 20, 20));
  Job second(2, trapezoid_table(40, 10, 20, 20));
  Bench bench(wide);
  bench.send(Kind::enable);
  bench.arm(first);
  const Tick tick = bench.arm(second);
  EXPECT_TRUE(handed_back(tick, first));
  EXPECT_EQ(tick.armed, 2U);
}

TEST(MotionAxis, OneArmIsOneStart) {
  Job job(1, there_and_back(0, 5, 0.1, Extrapolation::hold));
  Bench bench(wide);
  bench.play(job);
  bench.run(200);
  EXPECT_EQ(refusal(bench.send(Kind::start)), Cause::not_armed);
  bench.arm(job);
  EXPECT_EQ(refusal(bench.send(Kind::start)), Cause::none);
}

TEST(MotionAxis, SetPositionNeedsAStandstillAndANumber) {
  Job job(1, trapezoid_table(50, 10, 20, 20));
  Bench bench(wide);
  bench.send(Kind::enable);
  bench.arm(job);
  EXPECT_EQ(bench.step({command::SetPosition{.position = 3}}).position, 3);
  const Tick tick = bench.send(Kind::start);
  EXPECT_EQ(refusal(tick), Cause::not_at_start);
  EXPECT_EQ(tick.refused->value, 0);
  EXPECT_EQ(tick.refused->limit, 3);
  EXPECT_EQ(refusal(bench.step({command::SetPosition{.position = NAN}})), Cause::no_value);
  bench.step({command::SetPosition{.position = 0}});
  bench.send(Kind::start);
  EXPECT_EQ(refusal(bench.step({command::SetPosition{.position = 0}})), Cause::in_motion);
}

TEST(MotionAxis, SetPositionStaysInsideThePositionRange) {
  AxisConfig config = wide;
  config.limits.position_min = -10;
  config.limits.position_max = 300;
  Bench bench(config);
  bench.send(Kind::enable);
  const Tick above = bench.step({command::SetPosition{.position = 9999}});
  ASSERT_EQ(refusal(above), Cause::position_limit);
  EXPECT_EQ(above.refused->value, 9999);
  EXPECT_EQ(above.refused->limit, 300);
  EXPECT_EQ(above.position, 0);
  EXPECT_EQ(bench.step({command::SetPosition{.position = 300}}).position, 300);
  const Tick below = bench.step({command::SetPosition{.position = -311, .relative = true}});
  ASSERT_EQ(refusal(below), Cause::position_limit);
  EXPECT_EQ(below.refused->value, -11);
  EXPECT_EQ(below.refused->limit, -10);
}

TEST(MotionAxis, ALinearAxisRejectsATargetOnTheOtherSideOfItsDirection) {
  Bench bench(wide);
  bench.send(Kind::enable);
  const auto asked = [&](double position, Direction direction) {
    return refusal(
        bench.step({command::MoveAbsolute{.position = position, .direction = direction}}));
  };
  EXPECT_EQ(asked(-5, Direction::positive), Cause::no_such_move);
  EXPECT_EQ(asked(5, Direction::negative), Cause::no_such_move);
  EXPECT_EQ(asked(5, Direction::positive), Cause::none);
  EXPECT_EQ(asked(-5, Direction::shortest), Cause::none);
}

}  // namespace
}  // namespace jounce::axis_test
