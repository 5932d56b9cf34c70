// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "jounce/axis/axis.hpp"
#include "jounce/axis/fifo_movement.hpp"

#include "axis/model/model_movements.hpp"
#include "axis/tables.hpp"
#include "support/loop_limit.hpp"

namespace jounce::axis_later_test {
namespace {

using namespace test;

const AxisConfig wide{.limits = limits(1e3, 1e5)};

Cause dropped(const Tick& tick) {
  return tick.dropped ? tick.dropped->cause : Cause::none;
}

// ---- orders at a tick ----------------------------------------------------------------------------

TEST(AxisLater, ACommandWaitsForItsTick) {
  Bench axis(wide);
  axis.send(Kind::enable);
  EXPECT_EQ(refusal(axis.step({.what = command::MoveAbsolute{.position = 10}, .at = 50})),
            Cause::none);
  EXPECT_EQ(axis.run(48).state, State::standstill);
  Tick tick = axis.step();
  EXPECT_EQ(tick.tick, 50);
  EXPECT_EQ(tick.state, State::discrete_motion);
  EXPECT_EQ(axis.run(500).position, 10);
}

TEST(AxisLater, AsIfItHadComeInThatTick) {
  const Command move{command::MoveRelative{.distance = 10, .dynamics = {.velocity = 50}}};
  Bench now(wide), later(wide);
  Command command = move;
  command.at = 20;
  now.send(Kind::enable);
  later.send(Kind::enable);
  later.step(command);
  now.run(1);
  for (int i = 2; i < 400; ++i) {
    const Tick expected = i == 20 ? now.step(move) : now.step();
    const Tick tick = later.step();
    ASSERT_EQ(tick.position, expected.position) << i;
    ASSERT_EQ(tick.velocity, expected.velocity) << i;
  }
}

TEST(AxisLater, ATickThatIsLeftOutIsObeyedInTheNextOne) {
  Bench axis(wide);
  axis.send(Kind::enable);
  axis.step({.what = command::MoveAbsolute{.position = 10}, .at = 10});
  axis.tick = 14;
  EXPECT_EQ(axis.step().state, State::discrete_motion);
}

TEST(AxisLater, OneWaitsAndWhatIsOverIsTooLate) {
  Bench axis(wide);
  axis.send(Kind::enable);
  axis.run(10);
  EXPECT_EQ(refusal(axis.step({.what = command::Hold{}, .at = 3})), Cause::no_movement);
  EXPECT_EQ(refusal(axis.step({.what = command::Halt{}, .at = 3})), Cause::too_late);
  axis.step({.what = command::MoveAbsolute{.position = 10}, .at = 50});
  EXPECT_EQ(refusal(axis.step({.what = command::Halt{}, .at = 60})), Cause::buffer_full);
}

// No caller waits for the answer any more: it is in Tick::dropped.
TEST(AxisLater, ACommandRejectedThenIsReportedAsDropped) {
  Bench axis(wide);
  axis.send(Kind::enable);
  axis.step({.what = command::MoveAbsolute{.position = 10}, .at = 20});
  axis.step({command::Disable{}});
  Bench other(wide);
  other.send(Kind::enable);
  other.step({command::CamOut{}});
  other.step({.what = command::MoveRelative{.distance = 1}, .at = 5});
  other.step({command::SetPosition{.position = 7}});
  const Tick tick = other.run(2);
  EXPECT_EQ(tick.tick, 5);
  EXPECT_EQ(dropped(tick), Cause::none);
  Bench third({.limits = limits(1e3, 1e5)});
  third.send(Kind::enable);
  third.step({.what = command::Hold{}, .at = 9});
  third.step({.what = command::Override{.factor = 7}, .at = 9});
  EXPECT_EQ(dropped(third.run(7)), Cause::no_value);
}

TEST(AxisLater, AStopAFaultAndADisableMakeItVoid) {
  for (const Kind kind : {Kind::stop, Kind::abort, Kind::disable, Kind::disarm}) {
    Bench axis(wide);
    axis.send(Kind::enable);
    axis.step({.what = command::MoveAbsolute{.position = 10}, .at = 50});
    EXPECT_EQ(dropped(axis.send(kind)), Cause::replaced) << name(kind);
    EXPECT_EQ(axis.run(100).position, 0) << name(kind);
  }
}

TEST(AxisLater, AGearGoesInAtItsTick) {
  Gear gear(1, 1), late(2, 1);
  Bench axis(wide);
  Inputs inputs;
  inputs.master = {0, 0, 0, 0};
  axis.send(Kind::enable);
  axis.step({command::Couple{.movement = &gear, .tick = 5}}, inputs);
  for (int i = 2; i < 5; ++i) EXPECT_EQ(axis.step({}, inputs).state, State::standstill);
  EXPECT_EQ(axis.step({}, inputs).state, State::synchronized_motion);
  const Tick tick = axis.step({command::Couple{.movement = &late, .tick = 5}}, inputs);
  EXPECT_EQ(refusal(tick), Cause::too_late);
  EXPECT_EQ(tick.handed_back[0], &late);
}

// ---- swaps from rows and onto them ---------------------------------------------------------------

/// A cubic from rest to rest.
SegmentRow row(double x, double p, bool last = false) {
  return {.x_end = x, .p_end = p, .v_start = 0, .v_end = 0, .degree = 3, .last = last};
}

const StartAt end = StartAt::end_of_table;

struct Rows {
  explicit Rows(std::uint64_t id) : path(id, {.each = 8, .limits = row_limits(wide)}) {}
  void add(double x, double p, bool last = false) {
    EXPECT_EQ(path.fifos().push(0, row(x, p, last)), RowRule::none);
  }
  FifoPath path;
};

TEST(AxisSwap, FromRowsOntoATableWhereTheyEnd) {
  Rows rows(1);
  rows.add(0.1, 5);
  rows.add(0.2, 0);
  Job job(2, there_and_back(3, 10, 0.5, Extrapolation::hold));
  Bench axis(wide);
  axis.send(Kind::enable);
  ASSERT_EQ(refusal(axis.step({command::Arm{.movement = &rows.path}})), Cause::none);
  ASSERT_EQ(refusal(axis.send(Kind::start)), Cause::none);
  axis.run(20);
  ASSERT_EQ(refusal(axis.arm(job)), Cause::none) << "the end of the rows is not known yet";
  ASSERT_EQ(refusal(axis.step({command::Start{.when = end}})), Cause::none);
  rows.add(0.3004, 3, true);  // between two ticks
  Tick tick = axis.step();
  for (test::LoopLimit loop; tick.job == 1 && loop.goes_on();) {
    ASSERT_EQ(tick.state, State::discrete_motion);
    tick = axis.step();
  }
  EXPECT_EQ(tick.job, 2U);
  EXPECT_EQ(tick.finished, 1U);
  EXPECT_EQ(tick.position, job.at(0.001 - 0.0004).slave[0]) << "at the very instant";
  tick = axis.run(600);
  EXPECT_EQ(tick.position, 3);
  EXPECT_EQ(tick.state, State::standstill);
}

TEST(AxisSwap, RowsThatEndElsewhereAreTheEnd) {
  Rows rows(1);
  rows.add(0.1, 5, true);
  Job job(2, there_and_back(3, 10, 0.5, Extrapolation::hold));
  Bench axis(wide);
  axis.send(Kind::enable);
  axis.step({command::Arm{.movement = &rows.path}});
  axis.send(Kind::start);
  axis.arm(job);
  axis.step({command::Start{.when = end}});
  Cause why = Cause::none;
  for (int i = 0; i < 200; ++i) {
    const Tick tick = axis.step();
    if (tick.dropped) why = tick.dropped->cause;
  }
  EXPECT_EQ(why, Cause::start_position);
  const Tick tick = axis.step();
  EXPECT_EQ(tick.state, State::standstill);
  EXPECT_EQ(tick.position, 5);
  EXPECT_EQ(tick.fault, Cause::none);
}

TEST(AxisSwap, FromATableOntoRowsAndFromRowsOntoRows) {
  Job job(1, there_and_back(0, 10, 0.5, Extrapolation::hold));
  Rows first(2), second(3);
  first.add(0.1, 5, true);
  second.add(0.1, -2, true);
  Bench axis(wide);
  axis.play(job, 100);
  ASSERT_EQ(refusal(axis.step({command::Arm{.movement = &first.path}})), Cause::none);
  ASSERT_EQ(refusal(axis.step({command::Start{.when = end}})), Cause::none);
  Tick tick = axis.run(420);
  EXPECT_EQ(tick.job, 2U);
  ASSERT_EQ(refusal(axis.step({command::Arm{.movement = &second.path}})), Cause::none);
  ASSERT_EQ(refusal(axis.step({command::Start{.when = end}})), Cause::none);
  tick = axis.run(300);
  EXPECT_EQ(tick.position, 5 - 2) << "rows count from where the axis stands";
  EXPECT_EQ(tick.finished, 3U);
  EXPECT_EQ(tick.fault, Cause::none);
}

TEST(AxisSwap, OntoRowsComesDownToFullSpeedOrDoesNotTakePlace) {
  for (const int left : {2, 150}) {  // ticks of the table, at twice its speed
    SCOPED_TRACE(left);
    Job job(1, there_and_back(0, 10, 0.5, Extrapolation::hold));
    Rows rows(2);
    rows.add(0.02, 1e-3);
    rows.add(0.4, 5);
    Bench axis({.limits = limits(1e3, 5000)});
    axis.send(Kind::enable);
    axis.step({command::Override{.factor = 2}});
    axis.arm(job);
    axis.send(Kind::start);
    ASSERT_EQ(axis.run(247 - left).rate, 2);
    ASSERT_EQ(refusal(axis.step({command::Arm{.movement = &rows.path}})), Cause::none);
    Tick tick = axis.step({command::Start{.when = end}});
    ASSERT_EQ(refusal(tick), Cause::none);
    Cause why = Cause::none;
    for (test::LoopLimit loop; tick.job == 1 && loop.goes_on();) {
      tick = axis.step();
      if (tick.dropped) why = tick.dropped->cause;
    }
    EXPECT_EQ(tick.fault, Cause::none);
    EXPECT_NEAR(tick.rate, 1, 1e-9);
    EXPECT_EQ(why, left < 10 ? Cause::rate_changing : Cause::none);
    EXPECT_EQ(tick.job, left < 10 ? 0U : 2U);
    EXPECT_EQ(tick.state, left < 10 ? State::standstill : State::discrete_motion);
  }
}

TEST(AxisSwap, OfAPathThatIsHeldAtOnce) {
  Job job(1, there_and_back(0, 10, 0.5, Extrapolation::wrap));
  Bench axis(wide);
  axis.play(job, 100);
  axis.send(Kind::hold);
  const Tick held = axis.run(300);
  ASSERT_EQ(held.velocity, 0);
  Job next(2, there_and_back(held.position, 4, 0.5, Extrapolation::hold));
  ASSERT_EQ(refusal(axis.arm(next)), Cause::none);
  Tick tick = axis.send(Kind::start);
  EXPECT_EQ(refusal(tick), Cause::none);
  EXPECT_EQ(tick.job, 2U);
  EXPECT_EQ(tick.handed_back[0], &job);
  tick = axis.run(600);
  EXPECT_EQ(tick.state, State::standstill);
  EXPECT_DOUBLE_EQ(tick.position, held.position);
}

// ---- a stream that is declared complete ----------------------------------------------------------

TEST(AxisLater, AStreamThatIsDeclaredCompleteEndsWithoutAnUnderrun) {
  for (const bool declared : {true, false}) {
    Rows rows(1);
    rows.add(0.1, 5);
    rows.add(0.2, 8);
    Bench axis(wide);
    axis.send(Kind::enable);
    axis.step({command::Arm{.movement = &rows.path}});
    axis.send(Kind::start);
    axis.run(50);
    if (declared) {
      EXPECT_TRUE(rows.path.fifos().complete());
      EXPECT_TRUE(rows.path.fifos().complete()) << "pushed twice";
      EXPECT_EQ(rows.path.fifos().push(0, row(0.3, 9)), RowRule::after_last);
    }
    const Tick tick = axis.run(300);
    EXPECT_EQ(tick.fault, declared ? Cause::none : Cause::underrun);
    EXPECT_EQ(tick.state, declared ? State::standstill : State::error_stop);
    if (declared) {
      EXPECT_EQ(tick.position, 8);
    }
  }
}

TEST(AxisLater, AfterAnUnderrunItMayBeDeclaredCompleteAndResumed) {
  Rows rows(1);
  rows.add(0.1, 5);
  Bench axis(wide);
  axis.send(Kind::enable);
  axis.step({command::Arm{.movement = &rows.path}});
  axis.send(Kind::start);
  ASSERT_EQ(axis.run(300).fault, Cause::underrun);
  EXPECT_TRUE(rows.path.fifos().complete());
  axis.send(Kind::reset);
  axis.send(Kind::resume);
  const Tick tick = axis.run(300);
  EXPECT_EQ(tick.position, 5);
  EXPECT_EQ(tick.state, State::standstill);
}

TEST(AxisLater, WhatDoesNotEndAtRestIsNotComplete) {
  Rows rows(1);
  EXPECT_FALSE(rows.path.fifos().complete()) << "no rows";
  EXPECT_EQ(rows.path.fifos().push(
                0, {.x_end = 0.1, .p_end = 5, .v_start = 0, .v_end = 100, .degree = 3}),
            RowRule::none);
  EXPECT_FALSE(rows.path.fifos().complete());
  FifoPath tables(2, {.stream = false});
  EXPECT_FALSE(tables.fifos().complete());
}

}  // namespace
}  // namespace jounce::axis_later_test
