// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include <gtest/gtest.h>

#include "jounce/axis/axis.hpp"
#include "jounce/axis/detail/path_clock.hpp"

#include "axis/model/model_movements.hpp"
#include "axis/tables.hpp"
#include "support/loop_limit.hpp"

namespace jounce::axis_swap_test {
namespace {

using namespace test;

const AxisConfig wide{.limits = limits(1e3, 1e5)};

/// One turn of a table that passes its wrap at speed: p = 10 sin(2 pi t / T) by quintics through
/// points that are exact in p, v and a.
TablePtr turning(double T, double amplitude) {
  Columns c;
  const double w = 2 * M_PI / T;
  for (int i = 0; i <= 8; ++i) {
    const double x = M_PI / 4 * i;
    c.x.push_back(T / 8 * i);
    c.p.push_back(i % 4 == 0 ? 0 : amplitude * std::sin(x));
    c.v.push_back(amplitude * w * std::cos(x));
    c.a.push_back(i % 4 == 0 ? 0 : -amplitude * w * w * std::sin(x));
  }
  return table(Domain::time, Interpolation::quintic_hermite, Extrapolation::wrap, std::move(c));
}

/// From rest onto the turning table, at its velocity at 0.
TablePtr run_up(double T, double amplitude) {
  const double v = amplitude * 2 * M_PI / T;
  return table(Domain::time, Interpolation::quintic_hermite, Extrapolation::hold,
               {{0, 0.2}, {-0.1 * v, 0}, {0, v}, {0, 0}});
}

void start_at_end(Bench& bench, Job& job) {
  ASSERT_EQ(refusal(bench.arm(job)), Cause::none);
  ASSERT_EQ(refusal(bench.step({command::Start{.when = StartAt::end_of_table}})), Cause::none);
}

TEST(AxisSwap, ARepeatingTableIsReplacedAtItsWrapWithoutAStop) {
  const TablePtr first = there_and_back(0, 10, 0.5, Extrapolation::wrap);
  const TablePtr second = there_and_back(0, -6, 0.5, Extrapolation::hold);
  Job a(1, first);
  Job b(2, second);
  Bench bench(wide);
  bench.play(a, 700);
  start_at_end(bench, b);
  Tick tick = bench.run(297);  // path time 0.999
  EXPECT_EQ(tick.job, 1U);
  EXPECT_TRUE(tick.waiting);
  tick = bench.step();
  EXPECT_EQ(tick.job, 2U);
  EXPECT_EQ(tick.handed_back[0], &a);
  for (int k = 1; k < 500; ++k) {
    tick = bench.step();
    ASSERT_NEAR(tick.position, second->jet(k * 1e-3)[0], 1e-9) << k;
  }
  EXPECT_EQ(bench.step().state, State::standstill);
}

// The end of a pass is requested, then a hold, then another table: that one plays to its own end.
TEST(AxisSwap, TheRequestedEndOfAPassEndsWithItsTable) {
  Job wraps(1, there_and_back(0, 10, 0.5, Extrapolation::wrap));
  Bench bench(wide);
  bench.play(wraps, 100);
  ASSERT_EQ(refusal(bench.send(Kind::finish)), Cause::none);
  bench.send(Kind::hold);
  const double stands = bench.run(100).position;
  Job next(2, there_and_back(stands, 5, 2, Extrapolation::hold));
  ASSERT_EQ(refusal(bench.arm(next)), Cause::none);
  ASSERT_EQ(refusal(bench.send(Kind::start)), Cause::none);
  const Tick last = bench.run(1999);
  EXPECT_EQ(last.job, 2U);
  EXPECT_EQ(bench.run(2).reason, Cause::none) << "its end is not the end of a pass";
}

TEST(AxisSwap, TablesThatMeetAtSpeedAreJoinedWithinATick) {
  Job slow(1, turning(0.5, 2));
  Job same(2, turning(0.25, 1));    // the same velocity where it begins
  Job faster(3, turning(0.25, 2));  // twice that
  const AxisConfig config{.limits = limits(100, 3000)};
  EXPECT_EQ(slow.admit(config, {0, 0, 0})->cause, Cause::start_velocity) << "from rest";
  const MotionState end = *slow.end();
  EXPECT_FALSE(same.admit(config, end));
  EXPECT_EQ(faster.admit(config, end)->cause, Cause::start_velocity);
}

TEST(AxisSwap, IsHeldUpByAHoldAndUndoneByAStop) {
  Job a(1, there_and_back(0, 10, 0.5, Extrapolation::wrap));
  Job b(2, there_and_back(0, -6, 0.5, Extrapolation::hold));
  Bench bench(wide);
  bench.play(a, 100);
  start_at_end(bench, b);
  bench.send(Kind::hold);
  EXPECT_EQ(bench.run(2000).job, 1U);
  bench.send(Kind::resume);
  EXPECT_EQ(bench.run(600).job, 2U);

  Bench other(wide);
  other.play(a, 100);
  start_at_end(other, b);
  EXPECT_EQ(other.send(Kind::stop).handed_back[0], &b);
  EXPECT_EQ(other.run(1000).state, State::standstill);
  EXPECT_EQ(other.step().finished, 0U);
}

TEST(AxisSwap, WhatDoesNotMeetIsNotArmed) {
  Job a(1, there_and_back(0, 10, 0.5, Extrapolation::wrap));
  Job elsewhere(2, there_and_back(1, -6, 0.5, Extrapolation::hold));
  Bench bench(wide);
  bench.play(a);
  EXPECT_EQ(refusal(bench.arm(elsewhere)), Cause::start_position);
}

// The run-up does not end at rest: only a swap could follow it, so it is not admitted alone.
TEST(AxisSwap, ATableThatEndsAtSpeedIsNotAdmitted) {
  Job up(1, run_up(0.5, 2));
  EXPECT_EQ(up.admit({.limits = limits(100, 3000)}, {up.first().slave[0], 0, 0})->cause,
            Cause::end_velocity);
}

TEST(AxisSwap, ACamIsChangedWhereItsMasterPassesAPosition) {
  const auto cam = [](double reach) {
    return table(Domain::master, Interpolation::quintic_hermite, Extrapolation::wrap,
                 {{0, 90, 180, 270, 360}, {0, reach, 0, 0, 0}, {0, 0, 0, 0, 0}, {0, 0, 0, 0, 0}});
  };
  const TablePtr master = constant_master(3600, 720);
  Job a(1, master, cam(10));
  // The second cam's own master begins where the first one's will be.
  const TablePtr later = table(Domain::time, Interpolation::linear, Extrapolation::hold,
                               {{0, 4}, {225, 3105}, {}, {}});
  Job b(2, later, cam(4));
  Bench bench({.limits = limits(1e3, 1e5)});
  bench.play(a, 50);
  ASSERT_EQ(refusal(bench.arm(b)), Cause::none);
  ASSERT_EQ(
      refusal(bench.step({command::Start{.when = StartAt::master_position, .position = 225}})),
      Cause::none);
  Tick tick = bench.step();
  for (test::LoopLimit loop; tick.job == 1 && loop.goes_on();)
    tick = bench.step({command::SetPosition{.position = 1}});
  EXPECT_EQ(tick.job, 2U);
  EXPECT_EQ(refusal(tick), Cause::synchronized) << "the swap does not obey this tick's command";
  EXPECT_NEAR(tick.master, 225, 0.72);  // passed within the tick, and the master goes on
  EXPECT_NEAR(tick.master - 225, 720 * (0.313 - 0.3125), 1e-6);
  for (int k = 0; k < 1000; ++k) {
    const Tick next = bench.step();
    ASSERT_NEAR(next.master - tick.master, 0.72, 1e-9);
    tick = next;
  }
}

// A virtual master that repeats leaps from 360 back to 0: that does not pass 180.
TEST(AxisSwap, AMasterThatRepeatsPassesNothingWhereItLeaps) {
  const auto cam = [](double reach) {
    return table(Domain::master, Interpolation::quintic_hermite, Extrapolation::wrap,
                 {{0, 90, 180, 270, 360}, {0, reach, 0, 0, 0}, {0, 0, 0, 0, 0}, {0, 0, 0, 0, 0}});
  };
  const auto turn = [](double from) {
    return table(Domain::time, Interpolation::linear, Extrapolation::wrap,
                 {{0, 0.5}, {from, from + 360}, {}, {}});
  };
  Job a(1, turn(0), cam(10));
  Job b(2, turn(180), cam(4));
  Bench bench({.limits = limits(1e3, 1e5)});
  bench.play(a, 300);  // the master is at 216
  ASSERT_EQ(refusal(bench.arm(b)), Cause::none);
  ASSERT_EQ(
      refusal(bench.step({command::Start{.when = StartAt::master_position, .position = 180}})),
      Cause::none);
  Tick tick = bench.step();
  double before = tick.master;
  for (; tick.job == 1; tick = bench.step()) before = tick.master;
  EXPECT_LT(before, 180);
  EXPECT_NEAR(tick.master, 180, 0.72);
  EXPECT_NEAR(tick.time, 0.752, 1.1e-3) << "in its second turn";
}

// At speed: both cams are the same from 0 to 90, and come down to different places.
TEST(AxisSwap, CamsThatMeetAreJoinedAtSpeedOnBothPathsToTheLastTick) {
  const auto cam = [](double rest) {
    return table(
        Domain::master, Interpolation::quintic_hermite, Extrapolation::wrap,
        {{0, 90, 180, 270, 360}, {0, 10, rest, rest, 0}, {0, 0, 0, 0, 0}, {0, 0, 0, 0, 0}});
  };
  const TablePtr first = cam(0);
  const TablePtr second = cam(5);
  Job a(1, constant_master(3600, 720), first);
  Job b(2,
        table(Domain::time, Interpolation::linear, Extrapolation::hold,
              {{0, 3195 / 720.0}, {405, 3600}, {}, {}}),
        second);
  Bench bench({.limits = limits(500, 2e4, 2e6)});
  bench.play(a, 500);
  // Its start is checked when the master reaches it.
  ASSERT_EQ(refusal(bench.arm(b)), Cause::none);
  ASSERT_EQ(
      refusal(bench.step({command::Start{.when = StartAt::master_position, .position = 405}})),
      Cause::none);
  Tick tick = bench.step();
  for (; tick.state == State::synchronized_motion; tick = bench.step()) {
    const Table& cam_now = tick.job == 1 ? *first : *second;
    ASSERT_NEAR(tick.position, cam_now.jet(tick.master)[0], 1e-9);
    if (tick.master > 540 && tick.master < 630) {
      ASSERT_NEAR(tick.position, 5, 1e-9);
    }
  }
  EXPECT_EQ(tick.fault, Cause::none);
  EXPECT_EQ(tick.finished, 2U);
  EXPECT_EQ(tick.master, 3600);
}

TEST(AxisSwap, ACamThatDoesNotMeetThereIsHandedBackAndTheFirstGoesOn) {
  const auto cam = [](double reach) {
    return table(Domain::master, Interpolation::quintic_hermite, Extrapolation::wrap,
                 {{0, 90, 180, 270, 360}, {0, reach, 0, 0, 0}, {0, 0, 0, 0, 0}, {0, 0, 0, 0, 0}});
  };
  Job a(1, constant_master(3600, 720), cam(10));
  Job b(2,
        table(Domain::time, Interpolation::linear, Extrapolation::hold,
              {{0, 3195 / 720.0}, {405, 3600}, {}, {}}),
        cam(9));
  Bench bench({.limits = limits(500, 2e4)});
  bench.play(a, 500);
  bench.arm(b);
  bench.step({command::Start{.when = StartAt::master_position, .position = 405}});
  Tick tick = bench.step();
  // A command of that very tick has an answer of its own.
  for (test::LoopLimit loop; tick.waiting && loop.goes_on();)
    tick = bench.step({command::SetPosition{.position = 1}});
  EXPECT_EQ(refusal(tick), Cause::synchronized);
  ASSERT_TRUE(tick.dropped);
  EXPECT_EQ(tick.dropped->cause, Cause::start_position);
  EXPECT_EQ(tick.handed_back[0], &b);
  EXPECT_EQ(tick.job, 1U);
  EXPECT_EQ(tick.state, State::synchronized_motion);
}

TEST(AxisSwap, APassMayBeTheLastOne) {
  Job a(1, there_and_back(0, 10, 0.5, Extrapolation::wrap));
  Bench bench(wide);
  bench.play(a, 700);
  EXPECT_EQ(refusal(bench.send(Kind::finish)), Cause::none);
  Tick tick = bench.run(298);
  EXPECT_EQ(tick.state, State::discrete_motion);
  tick = bench.step();
  EXPECT_EQ(tick.state, State::standstill);
  EXPECT_EQ(tick.position, 0);
  EXPECT_EQ(tick.reason, Cause::pass_ended);
  EXPECT_EQ(tick.finished, 1U);
}

TEST(AxisSwap, AStartWaitsForALiveMaster) {
  Job a(1, trapezoid_table(50, 10, 20, 20));
  Bench bench({.limits = limits(10, 20)});
  bench.send(Kind::enable);
  bench.arm(a);
  const auto master = [](double m) {
    Inputs inputs;
    inputs.master = {m, 100, 0, 0};
    return inputs;
  };
  bench.step({command::Start{.when = StartAt::master_position, .position = 7.25}}, master(7));
  EXPECT_TRUE(bench.step({}, master(7.1)).waiting);
  EXPECT_EQ(bench.step({}, master(7.2)).state, State::standstill);
  const Tick tick = bench.step({}, master(7.3));  // passed half a tick ago
  EXPECT_EQ(tick.state, State::discrete_motion);
  EXPECT_NEAR(tick.velocity, 20 * 0.5e-3, 1e-12);
}

TEST(AxisSwap, AnOverrideOnAPathIsTheSamePathAtAnotherTime) {
  const TablePtr cycle = there_and_back(0, 10, 0.5, Extrapolation::wrap);
  Job a(1, cycle);
  Bench bench({.limits = limits(100, 2e4)});
  bench.play(a, 100);
  for (const double factor : {0.4, 1.9, 0.0, 1.0}) {
    const Tick told = bench.step({command::Override{.factor = factor}});
    EXPECT_NEAR(told.override_,
                factor == 1.9 ? highest_rate(a.peaks(), bench.axis.config()) : factor, 1e-12);
    EXPECT_NEAR(bench.run(400).rate, told.override_, 1e-12);
  }
  EXPECT_EQ(bench.axis.state(), State::discrete_motion);
}

}  // namespace
}  // namespace jounce::axis_swap_test
