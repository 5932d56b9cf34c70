// SPDX-License-Identifier: Apache-2.0
#include "jounce/axis/fifo_movement.hpp"

#include <cmath>
#include <limits>
#include <tuple>
#include <vector>

#include <gtest/gtest.h>

#include "jounce/axis/axis.hpp"
#include "jounce/controllers/googol/googol_pt.hpp"
#include "jounce/gear/follow.hpp"
#include "jounce/profiles/error.hpp"

#include "axis/follow/live.hpp"
#include "axis/tables.hpp"
#include "gear/follow_tables.hpp"
#include "support/googol_7_4.hpp"
#include "support/loop_limit.hpp"

namespace jounce::fifo_movement_test {
namespace {

using namespace test;
using googol::push;

Bench moving(FifoPath& path, const AxisConfig& config) {
  Bench bench(config);
  bench.send(Kind::enable);
  EXPECT_FALSE(bench.step({command::Arm{.movement = &path}}).refused);
  EXPECT_FALSE(bench.send(Kind::start).refused);
  return bench;
}

const AxisConfig fast{.limits = limits(1e5, 1e9)};

// Googol manual 7.4, example 7-3: increments 1024/2048/1024 pulses of 1024 ms each.
TEST(FifoPath, PlaysExample73) {
  const std::vector<PtPoint> points{{1.024, 1024}, {2.048, 3072}, {3.072, 4096}};
  FifoPath path(3, {.stream = false});
  for (const PtPoint& p : points) ASSERT_EQ(push(path.fifos(), 0, p), RowRule::none);
  Bench bench = moving(path, {.limits = limits(2000.001, 1954)});
  const Trajectory whole = pt<OverTime>(points);
  for (int k = 1; k < 3072; ++k) {
    const Tick now = bench.step();
    ASSERT_EQ(now.state, State::discrete_motion);
    const Jet expected = whole.jet(k * 1e-3);
    ASSERT_NEAR(now.position, expected[0], 1e-11) << k;
    ASSERT_NEAR(now.velocity, expected[1], 1e-9) << k;
    if (k == 1024) {
      EXPECT_NEAR(now.velocity, 2000, 1e-9) << "notes: end velocities 2, 2, 0 pulse/ms";
    }
  }
  const Tick end = bench.step();
  EXPECT_EQ(end.position, 4096);
  EXPECT_EQ(end.state, State::standstill);
  EXPECT_EQ(end.finished, 1U);
  EXPECT_EQ(path.fifos().passes(), 1);
}

TEST(FifoPath, TablesAreKeptAndPlayedAgainInLoops) {
  FifoPath path(3, {.stream = false, .loops = 3});
  for (const int fifo : {0, 1})
    for (const PtPoint& p : {PtPoint{0.128, 64}, {0.256, 0, PtType::stop}})
      ASSERT_EQ(push(path.fifos(), fifo, p), RowRule::none);
  Bench bench = moving(path, {.limits = limits(1001, 1.1e6)});
  bench.run(700);
  EXPECT_EQ(path.fifos().passes(), 2);
  EXPECT_FALSE(path.fifos().clear(0)) << "in use";
  EXPECT_TRUE(path.fifos().clear(1)) << "the idle one, while moving";
  Tick now = bench.run(68);
  EXPECT_EQ(now.state, State::standstill);
  EXPECT_EQ(now.position, 0);
  path.fifos().set_loops(0);
  bench.step({command::Arm{.movement = &path}});
  bench.send(Kind::start);
  now = bench.run(100 * 256 + 64);
  EXPECT_NEAR(now.position, 16, 1e-9);
  EXPECT_EQ(now.state, State::discrete_motion);
  EXPECT_EQ(path.fifos().passes(), 100);
}

// 126 segments through 2 x 32 slots: push while there is space, start when there is none, refill.
TEST(FifoPath, PlaysExample74ThroughTwoFifosOf32) {
  const auto points = example_7_4(1000);
  const auto rows = rows_of(points);
  ASSERT_EQ(rows.size(), 126U);
  FifoPath path(4, {.each = 32});
  std::size_t pushed = 0;
  const auto refill = [&] {
    const std::size_t before = pushed;
    while (pushed < rows.size() && path.fifos().push(0, rows[pushed]) == RowRule::none) ++pushed;
    return pushed - before;
  };
  EXPECT_EQ(refill(), 64U) << "both are full";
  EXPECT_EQ(path.fifos().push(0, rows[pushed]), RowRule::full);
  Bench bench = moving(path, {.limits = limits(50100, 1e7)});
  const Trajectory whole = pt<OverTime>(points);
  std::vector<std::size_t> refills;
  Tick now;
  for (int k = 1; k < 2000; ++k) {
    now = bench.step();
    ASSERT_EQ(now.state, State::discrete_motion) << k << " " << name(now.fault);
    ASSERT_NEAR(now.position, whole.jet(k * 1e-3)[0], 1e-9) << k;
    if (k == 240) {
      EXPECT_NEAR(now.position, 7451.79, 5e-3) << "notes: the 15th segment's end";
      EXPECT_NEAR(now.velocity, 49901.3, 5e-2);
    }
    if (k == 496) {
      EXPECT_NEAR(now.position, 15899.5772, 5e-5) << "notes: the greatest";
    }
    if (const std::size_t n = refill(); n > 0) refills.push_back(n);
  }
  EXPECT_EQ(refills, (std::vector<std::size_t>{32, 30})) << "space comes back in blocks of a FIFO";
  now = bench.step();
  EXPECT_EQ(now.state, State::standstill);
  EXPECT_EQ(now.position, 0);
}

TEST(FifoPath, IsTheTableToTheLastBit) {
  const TablePtr table = trapezoid_table(50, 10, 20, 20);
  FifoPath path(1, {.each = 2, .from = start_of(*table)});
  for (const SegmentRow& row : rows_of(*table)) ASSERT_EQ(path.fifos().push(0, row), RowRule::none);
  Bench bench = moving(path, {.limits = limits(10, 20)});
  for (int k = 1; k < 5500; ++k) {
    const Tick now = bench.step();
    const Jet expected = table->jet(k * 1e6 / 1e9);
    ASSERT_EQ(now.position, expected[0]) << k;
    ASSERT_EQ(now.velocity, expected[1]) << k;
    ASSERT_EQ(now.acceleration, expected[2]) << k;
  }
}

/// Straight on at 10 u/s, in rows of 0.1 s, after a second of speeding up.
std::vector<SegmentRow> straight(int rows) {
  std::vector<SegmentRow> all{{.x_end = 1, .p_end = 5, .v_start = 0}};
  for (int i = 1; i < rows; ++i)
    all.push_back(
        {.x_end = 1 + 0.1 * i, .p_end = 5.0 + i, .v_start = 10, .v_end = 10, .degree = 3});
  return all;
}

TEST(FifoPath, ReportsTheKnownLengthAndThatMoreFollows) {
  FifoPath path(1, {.each = 100, .limits = row_limits({.limits = limits(10, 20)})});
  for (const SegmentRow& row : straight(11)) ASSERT_EQ(path.fifos().push(0, row), RowRule::none);
  EXPECT_EQ(path.known(), 2);
  EXPECT_TRUE(path.growing());
  EXPECT_NEAR(path.peaks().velocity, 10, 1e-12);
  EXPECT_EQ(path.peaks().acceleration, 20) << "the limit: more is to come";
  ASSERT_EQ(path.begin({7, 0, 0}, {}), Cause::none);
  EXPECT_EQ(path.at({1, 1e-3, {}}).slave[0], 12);
  EXPECT_EQ(path.progress(), Progress::running);
  EXPECT_EQ(path.known(), 2);
  EXPECT_EQ(path.fifos().push(0, {.x_end = 3, .p_end = 10, .v_end = 0, .last = true}),
            RowRule::velocity_step)
      << "it would begin at -10";
  EXPECT_EQ(path.fifos().push(0, {.x_end = 3, .p_end = 20, .v_end = 0, .last = true}),
            RowRule::none);
  EXPECT_FALSE(path.growing());
  EXPECT_EQ(path.at({3, 1e-3, {}}).slave[0], 27);
  EXPECT_EQ(path.progress(), Progress::done);
}

// The axis stops on the path, within its limits, on what is known; and goes on when more is.
TEST(FifoPath, ThatStarvesIsStoppedOnItsPathAndResumes) {
  const AxisConfig config{.limits = limits(10, 20)};
  FifoPath path(1, {.each = 100, .limits = row_limits(config)});
  const auto rows = straight(21);
  for (std::size_t i = 0; i < 11; ++i) ASSERT_EQ(path.fifos().push(0, rows[i]), RowRule::none);
  Bench bench = moving(path, config);
  Tick now;
  const auto run = [&](int ticks) {
    for (int k = 0; k < ticks; ++k) {
      const double before = now.velocity;
      now = bench.step();
      ASSERT_LE(std::abs(now.velocity - before), 0.04 + 1e-9) << now.tick;
      ASSERT_LE(std::abs(now.velocity), 10 + 1e-9);
    }
  };
  run(3000);
  EXPECT_EQ(now.fault, Cause::underrun);
  EXPECT_EQ(now.velocity, 0);
  EXPECT_LT(now.position, 15) << "what was known";
  EXPECT_GT(now.position, 10);
  for (std::size_t i = 11; i < rows.size(); ++i)
    ASSERT_EQ(path.fifos().push(0, rows[i]), RowRule::none);
  ASSERT_EQ(path.fifos().push(0, {.x_end = 4, .p_end = 30, .v_end = 0, .last = true}),
            RowRule::none);
  EXPECT_FALSE(bench.send(Kind::reset).refused);
  EXPECT_FALSE(bench.send(Kind::resume).refused);
  run(5000);
  EXPECT_EQ(now.state, State::standstill);
  EXPECT_NEAR(now.position, 30, 1e-12);
  EXPECT_EQ(now.fault, Cause::none);
}

// The cycle in which the rows run short wakes up late: the stop begins where it would have begun in time, so
// that it still ends on the path, within the limits, and can be resumed.
TEST(FifoPath, ThatStarvesInALateCycleStopsOnItsPathAsWell) {
  const AxisConfig config{.limits = limits(10, 20)};
  const auto rows = straight(21);
  const auto begun = [&](FifoPath& path) {
    for (std::size_t i = 0; i < 11; ++i) EXPECT_EQ(path.fifos().push(0, rows[i]), RowRule::none);
    return moving(path, config);
  };
  FifoPath in_time(1, {.each = 100, .limits = row_limits(config)});
  Bench first = begun(in_time);
  while (first.step().fault == Cause::none) ASSERT_LT(first.tick, 2000);
  for (const std::int64_t skipped : {1, 2, 5, 20, 60})
    for (std::int64_t last = first.tick - skipped - 1; last <= first.tick; ++last) {
      SCOPED_TRACE(::testing::Message() << skipped << " left out after tick " << last);
      FifoPath path(1, {.each = 100, .limits = row_limits(config)});
      Bench bench = begun(path);
      Tick now = bench.run(last - bench.tick);
      bench.tick += skipped;
      double before = now.velocity;
      now = bench.step();
      ASSERT_LE(std::abs(now.velocity - before), 0.04 * static_cast<double>(skipped + 1) + 1e-9);
      for (test::LoopLimit loop; now.velocity > 0 && loop.goes_on();) {
        before = now.velocity;
        now = bench.step();
        ASSERT_LE(std::abs(now.velocity - before), 0.04 + 1e-9) << now.tick;
      }
      EXPECT_EQ(now.fault, Cause::underrun);
      for (std::size_t i = 11; i < rows.size(); ++i)
        ASSERT_EQ(path.fifos().push(0, rows[i]), RowRule::none);
      EXPECT_FALSE(bench.send(Kind::reset).refused);
      ASSERT_FALSE(bench.send(Kind::resume).refused) << "it has left its path";
    }
}

TEST(FifoPath, ThatRunsDryKeepsItsLastSetpoint) {
  FifoPath path(1, {.each = 100});
  for (const SegmentRow& row : straight(2)) path.fifos().push(0, row);
  ASSERT_EQ(path.begin({0, 0, 0}, {}), Cause::none);
  EXPECT_NEAR(path.at({1.1, 1e-3, {}}).slave[1], 10, 1e-12) << "to the very end of what is known";
  EXPECT_EQ(path.progress(), Progress::running);
  const Setpoint last = path.at({1.101, 1e-3, {}});
  EXPECT_EQ(path.progress(), Progress::broken);
  EXPECT_EQ(path.cause(), Cause::underrun);
  EXPECT_EQ(last.slave[0], 6);
}

TEST(FifoPath, RejectsWhatCannotBegin) {
  const auto refused = [](FifoPath& path, const MotionState& axis) {
    const auto refusal = path.admit(fast, axis);
    return refusal ? refusal->cause : Cause::none;
  };
  FifoPath empty(1, {});
  EXPECT_EQ(refused(empty, {}), Cause::no_movement);
  EXPECT_EQ(empty.begin({}, {}), Cause::no_movement);
  FifoPath path(1, {.from = RowStart{0, 3}});
  path.fifos().push(0, {.x_end = 1, .p_end = 3, .degree = 1});
  EXPECT_EQ(refused(path, {3, 0, 0}), Cause::none);
  EXPECT_EQ(refused(path, {3.1, 0, 0}), Cause::start_position);
  EXPECT_EQ(path.begin({3.1, 0, 0}, {}), Cause::start_position);
  EXPECT_EQ(refused(path, {3, 2e6, 0}), Cause::start_velocity);
  path.fifos().push(0, {.x_end = 2, .p_end = 3e6, .degree = 1});
  EXPECT_EQ(refused(path, {3, 0, 0}), Cause::velocity_limit);
  EXPECT_THROW(FifoPath(1, {.each = 0}), InputError);
  EXPECT_THROW(FifoPath(1, {.from = RowStart{NAN, 0}}), InputError);
}

const SegmentFifos::Reach up_to_80{0, 80};

AxisConfig in_300() {
  AxisConfig config = fast;
  config.limits.position_min = 0;
  config.limits.position_max = 300;
  return resolved(config);
}

// Issue: a table of 200..280 played at 0, and one of 0..80 played at 250 past 300.
TEST(FifoPath, BeginsAtItsOriginAloneAndWhereItsRangeFits) {
  const auto refused = [](FifoPath& path, double position) {
    const auto refusal = path.admit(in_300(), {position, 0, 0});
    return refusal ? refusal->cause : Cause::none;
  };
  FifoPath absolute(1, {.origin = 200, .range = up_to_80});
  absolute.fifos().push(0, {.x_end = 1, .p_end = 80, .degree = 1});
  EXPECT_EQ(refused(absolute, 200), Cause::none);
  EXPECT_EQ(refused(absolute, 0), Cause::start_position);
  EXPECT_EQ(absolute.begin({0, 0, 0}, {}), Cause::start_position);
  ASSERT_EQ(absolute.begin({200, 0, 0}, {}), Cause::none);
  EXPECT_EQ(absolute.at({0.5, 1e-3, {}}).slave[0], 240);
  FifoPath relative(2, {.range = up_to_80});
  relative.fifos().push(0, {.x_end = 1, .p_end = 80, .degree = 1});
  EXPECT_EQ(refused(relative, 220), Cause::none);
  EXPECT_EQ(refused(relative, 250), Cause::position_limit);
  FifoPath unannounced(3, {});
  unannounced.fifos().push(0, {.x_end = 1, .p_end = 80, .degree = 1});
  EXPECT_EQ(refused(unannounced, 0), Cause::position_limit) << "it may go anywhere";
  EXPECT_THROW(FifoPath(1, {.range = {1, 2}}), InputError);
  EXPECT_THROW(FifoPath(1, {.range = {-1, -0.5}}), InputError);
  EXPECT_THROW(FifoPath(1, {.origin = NAN}), InputError);
}

// Passes add up. The sender announces 80 and loops a bank that gains 60 a pass: the axis rests inside.
TEST(FifoPath, APassThatLeavesTheAnnouncedRangeDoesNotBegin) {
  for (const double rate : {60.0, 600.0}) {
    FifoPath path(1, {.stream = false, .loops = 0, .range = {0, 290}});
    const double t = 60 / rate;
    ASSERT_EQ(path.fifos().push(
                  0, {.x_end = t, .p_end = 60, .v_start = rate, .v_end = rate, .degree = 3}),
              RowRule::none);
    Bench bench(in_300());
    bench.send(Kind::enable);
    ASSERT_EQ(refusal(bench.arm(path)), Cause::none);
    bench.send(Kind::start);
    double most = 0;
    for (int k = 0; k < 6000; ++k) most = std::max(most, bench.step().position);
    EXPECT_LE(most, 300 + 1e-9) << rate;
    EXPECT_GE(most, 240 - rate * 1e-3 - 1e-9) << "the passes that fit are played, to the last tick";
    EXPECT_EQ(bench.step().velocity, 0);
    EXPECT_NE(bench.step().fault, Cause::none);
  }
}

// ---- follow --------------------------------------------------------------------------------------

/// Ramps of the master by `acceleration` to `velocity`, from 0; then steady.
std::function<Jet(double)> speeding_up(double velocity, double acceleration) {
  return [=](double t) -> Jet {
    const double T = velocity / acceleration;
    if (t < T) return {acceleration * t * t / 2, acceleration * t, acceleration, 0};
    return {velocity * (t - T / 2), velocity, 0, 0};
  };
}

// Fig. 7-13: the event at master 1000, a ramp to ratio 1 by 1500, the sync point at 2250.
TEST(FifoFollow, PlaysFig713) {
  FifoFollow follow(1, {.stream = false}, {.event = {FollowEvent::pass, 1000}});
  push(follow.fifos(), 0, {500, 250});
  push(follow.fifos(), 0, {1250, 1000});
  Follower slave{follow, steady(500)};  // pulse/s: 0.5 a tick
  ASSERT_EQ(slave.begin({}), Cause::none);
  EXPECT_EQ(slave.run(2000).slave[0], 0) << "stands on it, and has not left it";
  EXPECT_EQ(follow.progress(), Progress::waiting);
  slave.step();
  EXPECT_EQ(follow.progress(), Progress::running);
  EXPECT_NEAR(slave.run(999).slave[0], 250, 1e-9) << "at master 1500: stated";
  EXPECT_NEAR(slave.run(1).slave[1], 500, 1e-9) << "ratio 1";
  EXPECT_NEAR(slave.run(1498).slave[0], 999.5, 1e-9) << "at master 2249.5";
  EXPECT_NEAR(slave.run(1).slave[0], 1000, 1e-9);
  EXPECT_EQ(follow.progress(), Progress::done) << "the table ends at ratio 1, at speed";
  EXPECT_NEAR(slave.now().slave[1], 500, 1e-9) << "from which the axis brakes";
}

// Ended at ratio 1 between two ticks, the slave goes on at it to the tick, and the axis brakes from there.
TEST(FifoFollow, ThatEndsAtARatioBrakesWithinTheLimits) {
  for (const int dir : {0, 1, -1}) {
    FifoFollow follow(1, {.stream = false}, {.dir = dir});
    push(follow.fifos(), 0, {500, 250});
    push(follow.fifos(), 0, {1250.3, 1000.3});
    Bench bench({.limits = limits(1000, 2000)});
    bench.send(Kind::enable);
    const auto step = [&](const Command& command = {}) {
      Inputs inputs;
      const double speed = dir < 0 ? -500 : 500;
      inputs.master = {speed * static_cast<double>(++bench.tick) * 1e-3, speed, 0, 0};
      return bench.axis.step(bench.tick, command, inputs);
    };
    ASSERT_FALSE(step({command::Arm{.movement = &follow}}).refused);
    Tick before = step({command::Start{}});
    double fastest = 0;
    double left = 0;
    for (int k = 0; k < 4000; ++k) {
      const Tick now = step();
      if (left == 0 && now.state == State::discrete_motion) left = before.position;
      const double change = std::abs(now.velocity - before.velocity);
      ASSERT_LE(left == 0 ? 0 : change, 2 * (1 + 1e-9)) << k;
      fastest = std::max(fastest, now.velocity);
      before = now;
    }
    EXPECT_EQ(before.state, State::standstill);
    EXPECT_EQ(before.fault, Cause::none);
    EXPECT_EQ(before.reason, Cause::end_velocity);
    EXPECT_NEAR(fastest, 500, 1e-6);
    EXPECT_NEAR(left, 1000.3, 0.5) << "to the tick in which it ended";
    EXPECT_NEAR(before.position, left + 500.0 * 500 / 2 / 2000, 1);
  }
}

// Example 7-7: PASS at 50000 of a master that speeds up by 1 pulse/ms^2 to 50 pulse/ms.
// A table whose first row moves, started behind a master that moves: an axis that cannot jump to its velocity
// rejects the start and stays at rest. The velocity is that of the master times the rate of the first row.
TEST(FifoFollow, AStartThatWouldJumpIsNoFault) {
  for (const int dir : {0, 1, -1}) {
    const double speed = dir < 0 ? -500 : 500;
    for (const double acceleration : {2e4, 6e5}) {  // permits a step of 20 or 600 in a tick
      FifoFollow follow(1, {.stream = false}, {.dir = dir});
      push(follow.fifos(), 0, {500, 250, PtType::even});  // rate 0.5 from its beginning
      push(follow.fifos(), 0, {1000, 500, PtType::even});
      Bench bench({.limits = limits(3000, acceleration)});
      bench.send(Kind::enable);
      const auto step = [&](const Command& command = {}) {
        ++bench.tick;
        return bench.axis.step(bench.tick, command,
                               at_master(speed * 1e-3 * static_cast<double>(bench.tick), speed));
      };
      ASSERT_FALSE(step({command::Arm{.movement = &follow}}).refused);
      const Tick start = step({command::Start{}});
      const bool possible = acceleration > 2e5;
      EXPECT_EQ(refusal(start), possible ? Cause::none : Cause::start_jump) << dir;
      if (!possible) {
        EXPECT_NEAR(start.refused->value, std::abs(speed) / 2, 1e-9) << dir;
        EXPECT_EQ(start.refused->limit, 0);
      }
      Tick now = start;
      for (int k = 0; k < 100; ++k) {
        now = step();
        ASSERT_EQ(now.fault, Cause::none) << dir << ' ' << k;
      }
      EXPECT_EQ(now.state, possible ? State::synchronized_motion : State::standstill);
      EXPECT_NEAR(now.position, possible ? 100 * std::abs(speed) / 2 * 1e-3 : 0, 1e-9) << dir;
      if (possible) continue;
      // If its master stands, the same table begins, also after a start that was rejected.
      ASSERT_FALSE(bench.step({command::Arm{.movement = &follow}}, at_master(0, 0)).refused);
      EXPECT_FALSE(bench.step({command::Start{}}, at_master(0, 0)).refused);
      EXPECT_EQ(bench.step({}, at_master(0, 0)).job, 1U);
    }
  }
}

/// The same table waits for its master at 30: if the axis cannot jump to the velocity of the first row, the
/// start is dropped at the event, and the axis stays at rest without a fault.
TEST(FifoFollow, AnEventThatWouldCauseAJumpIsNoFault) {
  for (const int dir : {1, -1}) {
    const double speed = dir * 500.0;
    for (const auto& [velocity, acceleration, cause] :
         {std::tuple{3000.0, 2e4, Cause::start_jump}, std::tuple{200.0, 6e5, Cause::velocity_limit},
          std::tuple{3000.0, 6e5, Cause::none}}) {
      FifoFollow follow(1, {.stream = false},
                        {.event = {FollowEvent::pass, dir * 30.0, dir}, .dir = dir});
      push(follow.fifos(), 0, {500, 250, PtType::even});
      push(follow.fifos(), 0, {1000, 500, PtType::even});
      Bench bench({.limits = limits(velocity, acceleration)});
      bench.send(Kind::enable);
      const auto step = [&](const Command& command = {}) {
        ++bench.tick;
        return bench.axis.step(bench.tick, command,
                               at_master(speed * 1e-3 * static_cast<double>(bench.tick), speed));
      };
      ASSERT_FALSE(step({command::Arm{.movement = &follow}}).refused);
      ASSERT_EQ(refusal(step({command::Start{}})), Cause::none) << "it waits";
      std::optional<Refusal> dropped;
      Tick now;
      for (int k = 0; k < 100; ++k) {
        now = step();
        ASSERT_EQ(now.fault, Cause::none) << dir << ' ' << k;
        if (now.dropped) dropped = now.dropped;
      }
      if (cause == Cause::none) {
        EXPECT_EQ(now.state, State::synchronized_motion);
        EXPECT_FALSE(dropped);
        continue;
      }
      ASSERT_TRUE(dropped) << dir;
      EXPECT_EQ(dropped->cause, cause);
      EXPECT_NEAR(std::abs(dropped->value), 250, 1e-9);
      EXPECT_EQ(now.state, State::standstill);
      EXPECT_EQ(now.reason, cause);
      EXPECT_EQ(now.position, 0);
      EXPECT_EQ(now.job, 0U);
    }
  }
}

TEST(FifoFollow, PlaysExample77) {
  FifoFollow follow(1, {.each = 16, .stream = false, .loops = 0},
                    {.event = {FollowEvent::pass, 50000}});
  const FollowTable table = test::example_7_7();
  for (const PtPoint& p : table.segments) push(follow.fifos(), 0, p);
  const auto master = speeding_up(50e3, 1e6);
  Follower slave{follow, master};
  ASSERT_EQ(slave.begin({}), Cause::none);
  const Cam exact = ::jounce::follow(FollowSpec{{table}}).cam;
  EXPECT_EQ(slave.run(1024).slave[0], 0);
  EXPECT_EQ(follow.progress(), Progress::waiting);
  double peak = 0;
  for (int k = 1025; k < 1025 + 5 * 1200; ++k) {
    const Setpoint now = slave.step();
    const double gone = master(k * 1e-3)[0] - 50000;  // trigger: 1025 ms
    ASSERT_NEAR(now.slave[0], gone > 0 ? exact.jet(gone)[0] : 0, 1e-6) << k;
    peak = std::max(peak, now.slave[1]);
  }
  EXPECT_NEAR(peak, 50e3, 1e-6) << "notes: peak 50 pulse/ms";
  EXPECT_NEAR(slave.step().slave[0], 5 * 40000, 1e-6) << "notes: 40000 pulses each 1200 ms";
}

/// The events of a movement in the ticks up to `last`, as kind, number, instant and master.
std::vector<std::tuple<ProfileEvent::Kind, std::int64_t, double, double>> events_to(
    Follower& slave, std::int64_t last) {
  std::vector<std::tuple<ProfileEvent::Kind, std::int64_t, double, double>> all;
  while (slave.tick < last) {
    slave.step();
    for (const ProfileEvent& e : slave.movement.events())
      all.emplace_back(e.kind, e.number, e.t, e.master);
  }
  return all;
}

// Example 7-7: the start event at 1025 ms, then a pass of 60000 pulses of the master each 1200 ms.
TEST(FifoFollow, ReportsItsStartEventAndEachPass) {
  FifoFollow follow(1, {.each = 16, .stream = false, .loops = 3},
                    {.event = {FollowEvent::pass, 50000}});
  for (const PtPoint& p : test::example_7_7().segments) push(follow.fifos(), 0, p);
  Follower slave{follow, speeding_up(50e3, 1e6)};
  ASSERT_EQ(slave.begin({}), Cause::none);
  const auto events = events_to(slave, 6000);
  ASSERT_EQ(events.size(), 4U);
  for (std::size_t k = 0; k < events.size(); ++k) {
    const auto& [kind, number, t, master] = events[k];
    EXPECT_EQ(kind, k == 0 ? ProfileEvent::Kind::begin : ProfileEvent::Kind::pass_end);
    EXPECT_EQ(number, k == 0 ? 1 : static_cast<std::int64_t>(k)) << "table 1, then passes";
    EXPECT_NEAR(t, 1.025 + 1.2 * static_cast<double>(k), 1e-9) << k;
    EXPECT_NEAR(master, 50000 + 60000 * static_cast<double>(k), 1e-9) << k;
  }
  EXPECT_EQ(follow.progress(), Progress::done);
}

// Without an event, a table begins at the start. The second one begins where the pass of the first one ends,
// and counts its own passes. A backward direction counts the travel from the start downwards.
TEST(FifoFollow, ReportsASwitchAtTheEndOfThePass) {
  for (const int dir : {0, 1, -1}) {
    FifoFollow follow(1, {.stream = false, .loops = 0}, {.dir = dir});
    push(follow.fifos(), 0, {100, 50, PtType::even});
    push(follow.fifos(), 1, {40, 20, PtType::even});
    ASSERT_TRUE(follow.fifos().queue_switch());
    const double sign = dir < 0 ? -1 : 1;
    Follower slave{follow, steady(sign * 800)};  // 0.8 a tick
    ASSERT_EQ(slave.begin({}), Cause::none);
    const auto events = events_to(slave, 230);  // 184 of the master
    using Kind = ProfileEvent::Kind;
    const std::vector<std::tuple<Kind, std::int64_t, double>> want{{Kind::begin, 1, 0},
                                                                   {Kind::pass_end, 1, 100},
                                                                   {Kind::begin, 2, 100},
                                                                   {Kind::pass_end, 1, 140},
                                                                   {Kind::pass_end, 2, 180}};
    ASSERT_EQ(events.size(), want.size()) << dir;
    for (std::size_t k = 0; k < want.size(); ++k) {
      const auto& [kind, number, t, master] = events[k];
      EXPECT_EQ(std::tuple(kind, number), std::tuple(std::get<0>(want[k]), std::get<1>(want[k])));
      EXPECT_NEAR(master, sign * std::get<2>(want[k]), 1e-9) << k;
      EXPECT_NEAR(t, std::get<2>(want[k]) / 800, 1e-9) << k;
    }
  }
}

// A master that is several passes further in the next tick: the number of the last pass shows the others.
TEST(FifoFollow, ReportsTheLastOfSeveralPassesInATick) {
  FifoFollow follow(1, {.stream = false, .loops = 0});
  push(follow.fifos(), 0, {10, 5, PtType::even});
  double master = 0;
  Follower slave{follow, [&](double) { return Jet{master, 1000, 0, 0}; }};
  ASSERT_EQ(slave.begin({}), Cause::none);
  master = 47;
  slave.step();
  const auto events = follow.events();
  ASSERT_EQ(events.size(), 2U) << "the begin, and the last pass";
  EXPECT_EQ(events[1].number, 4);
  EXPECT_EQ(events[1].master, 40);
  master = 1e6 + 3;
  slave.step();
  ASSERT_EQ(follow.events().size(), 1U);
  EXPECT_EQ(follow.events()[0].number, 100000);
  EXPECT_EQ(follow.events()[0].master, 1e6);
  master = 1e6 + 5;
  slave.step();
  EXPECT_TRUE(follow.events().empty());
}

// Example 7-6: a catch-up of (5000, 2500) to ratio 1, then the shear's cycle without end.
TEST(FifoFollow, PlaysExample76) {
  FifoFollow follow(1, {.each = 16, .stream = false, .loops = 0});
  push(follow.fifos(), 0, {5000, 2500});
  const FollowTable cycle = test::shear_cycle();
  for (const PtPoint& p : cycle.segments) push(follow.fifos(), 1, p);
  Follower slave{follow, steady(10000)};
  ASSERT_EQ(slave.begin({100, 0, 0}), Cause::none);
  ASSERT_TRUE(follow.fifos().queue_switch());
  const Cam exact = ::jounce::follow(FollowSpec{{{{{5000, 2500}}}, cycle}}).cam;
  for (int k = 1; k < 1500; ++k) {
    const Setpoint now = slave.step();
    ASSERT_NEAR(now.slave[0], 100 + exact.jet(10.0 * k)[0], 1e-9) << k;
  }
  EXPECT_EQ(follow.fifos().space(0), 16U) << "switched";
  EXPECT_NEAR(slave.run(1).slave[1], 10000, 1e-6) << "notes: from ratio 1 to ratio 1";
  EXPECT_NEAR(slave.run(500).slave[1], 6000, 1e-6) << "0.6 in the middle of the cycle";
  EXPECT_NEAR(slave.run(7 * 1000).slave[1], 6000, 1e-6) << "in every cycle";
}

// Example 7-8: 802 segments in dynamic memory.
TEST(FifoFollow, PlaysExample78) {
  FifoFollow follow(1, {.each = 1000, .stream = false, .total = 1000});
  const FollowTable table = test::example_7_8();
  for (const PtPoint& p : table.segments) ASSERT_EQ(push(follow.fifos(), 0, p), RowRule::none);
  EXPECT_EQ(follow.fifos().space(1), 198U) << "of 1000 in both";
  const Cam exact = ::jounce::follow({{table}}).cam;
  Follower slave{follow, steady(50e3)};
  ASSERT_EQ(slave.begin({}), Cause::none);
  for (int k = 1; k < 2400; ++k) {
    const Setpoint now = slave.step();
    ASSERT_NEAR(now.slave[0], exact.jet(50.0 * k)[0], 1e-9) << k;
    if (50 * k > 20000 && 50 * k < 100000) {
      ASSERT_NEAR(now.slave[1], 50e3, 1e-6) << "ratio 1";
    }
  }
  EXPECT_NEAR(slave.step().slave[0], 100000, 1e-9);
  EXPECT_EQ(follow.progress(), Progress::done);
}

// Example 7-9: the old table without end; bridge; the new table, from 0.6 to 0.6.
TEST(FifoFollow, PlaysExample79) {
  FifoFollow follow(1, {.each = 16, .stream = false, .loops = 0});
  for (const PtPoint& p : test::old_7_9().segments) push(follow.fifos(), 0, p);
  Follower slave{follow, steady(50e3)};  // 50 pulse/ms: 1200 ms a pass
  ASSERT_EQ(slave.begin({}), Cause::none);
  slave.run(1400);
  for (const PtPoint& p : test::bridge_7_9().segments) push(follow.fifos(), 1, p);
  EXPECT_FALSE(follow.fifos().clear(0));
  ASSERT_TRUE(follow.fifos().queue_switch());
  EXPECT_EQ(push(follow.fifos(), 0, {1e6, 0}), RowRule::in_use) << "it is about to be emptied";
  EXPECT_FALSE(follow.fifos().clear(1)) << "it is what comes next";
  EXPECT_NEAR(slave.run(1000).slave[0], 80000, 1e-9) << "two passes, to the end";
  slave.run(1);
  EXPECT_EQ(follow.fifos().space(0), 16U) << "how users see the switch";
  for (const PtPoint& p : test::new_7_9().segments) push(follow.fifos(), 0, p);
  ASSERT_TRUE(follow.fifos().queue_switch());
  slave.run(1198);
  double least = 1e9;
  double most = 0;
  for (int k = 0; k < 3 * 1200; ++k) {
    const Jet now = slave.step().slave;
    least = std::min(least, now[1]);
    most = std::max(most, now[1]);
  }
  EXPECT_NEAR(least, 30e3, 150) << "notes: oscillates between 30 and 50 pulse/ms";
  EXPECT_NEAR(most, 50e3, 1e-6);
  EXPECT_NEAR(slave.run(1).slave[0], 80000 + 46000 + 3 * 52000, 1e-6);
}

TEST(FifoFollow, ALostMasterBreaksIt) {
  for (const double nowhere : {std::nan(""), std::numeric_limits<double>::infinity()}) {
    FifoFollow follow(1, {.stream = false, .loops = 0});
    push(follow.fifos(), 0, {100, 50, PtType::even});
    double master = 0;
    Follower slave{follow, [&](double) { return Jet{master, 1000, 0, 0}; }};
    ASSERT_EQ(slave.begin({7, 0, 0}), Cause::none);
    master = 1;
    EXPECT_EQ(slave.step().slave[0], 7.5);
    master = nowhere;
    EXPECT_EQ(slave.step().slave[0], 7.5);
    EXPECT_EQ(follow.progress(), Progress::broken);
    EXPECT_EQ(follow.cause(), Cause::master_lost);
    EXPECT_EQ(slave.begin({7, 0, 0}), Cause::no_master_input);
  }
}

TEST(FifoFollow, StandsAtItsOriginOrDoesNotBegin) {
  FifoFollow follow(1, {.stream = false, .loops = 0, .origin = 5});
  push(follow.fifos(), 0, {100, 50, PtType::even});
  EXPECT_EQ(follow.begin({0, 0, 0}, {0, 1e-3, {0, 100, 0, 0}}), Cause::start_position);
  ASSERT_TRUE(follow.admit(fast, {0, 0, 0}));
  EXPECT_EQ(follow.admit(fast, {0, 0, 0})->cause, Cause::start_position);
  EXPECT_EQ(follow.begin({5, 0, 0}, {0, 1e-3, {0, 100, 0, 0}}), Cause::none);
}

// However short the first table is, a switch queued before the start comes at its end.
TEST(FifoFollow, ASwitchQueuedBeforeTheStartIsForTheFirstPass) {
  FifoFollow follow(1, {.stream = false, .loops = 0}, {.event = {FollowEvent::pass, 10}});
  push(follow.fifos(), 0, {1, 1, PtType::even});
  push(follow.fifos(), 1, {100, 50, PtType::even});
  ASSERT_TRUE(follow.fifos().queue_switch());
  Follower slave{follow, steady(1000)};
  ASSERT_EQ(slave.begin({}), Cause::none);
  EXPECT_EQ(slave.run(10).slave[0], 0);
  EXPECT_EQ(slave.run(1).slave[0], 1);
  EXPECT_EQ(slave.run(50).slave[0], 26) << "half of its master from 11 on";
}

// A switch that found nothing to switch to is not left for the next start.
TEST(FifoFollow, ASwitchThatDidNotComeIsVoid) {
  FifoFollow follow(1, {.stream = false, .loops = 1});
  push(follow.fifos(), 0, {1, 1, PtType::stop});
  push(follow.fifos(), 1, {1, 2, PtType::stop});
  ASSERT_TRUE(follow.fifos().queue_switch());
  ASSERT_TRUE(follow.fifos().clear(0));
  follow.choose(1);
  Follower slave{follow, steady(1000)};
  ASSERT_EQ(slave.begin({}), Cause::none);
  EXPECT_EQ(slave.run(5).slave[0], 2) << "its one pass; the other FIFO is empty";
  EXPECT_FALSE(follow.fifos().switch_queued());
}

// The motion depends on the number in the inputs, not on the arrival time of a row.
TEST(FifoPath, RowsOfAGreaterNumberAreNotThereYet) {
  FifoPath path(1, {.each = 4});
  SegmentFifos& fifos = path.fifos();
  path.see(0);
  fifos.stamp(1);
  ASSERT_EQ(fifos.push(0, {.x_end = 1, .p_end = 1, .degree = 1}), RowRule::none);
  EXPECT_EQ(path.begin({}, {}), Cause::no_movement);
  path.see(1);
  ASSERT_EQ(path.begin({}, {}), Cause::none);
  EXPECT_EQ(path.known(), 1);
  fifos.stamp(2);
  ASSERT_EQ(fifos.push(0, {.x_end = 2, .p_end = 2, .degree = 1, .last = true}), RowRule::none);
  EXPECT_EQ(path.known(), 1);
  EXPECT_TRUE(path.growing());
  path.see(2);
  EXPECT_EQ(path.known(), 2);
  EXPECT_FALSE(path.growing());
}

}  // namespace
}  // namespace jounce::fifo_movement_test
