// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "jounce/axis/live_gear.hpp"

#include "axis/bench.hpp"
#include "axis/model/model_movements.hpp"
#include "axis/src/motion/setpoint_check.hpp"
#include "axis/tables.hpp"
#include "support/loop_limit.hpp"
#include "support/random.hpp"

// The rule of the position range: docs/executor/axis.md, "The position range".

namespace jounce::range_test {
namespace {

using namespace test;

AxisConfig between(double low, double high, const Limits& others) {
  AxisConfig config{.limits = others};
  config.limits.position_min = low;
  config.limits.position_max = high;
  return config;
}

const Limits trapezoids = limits(500, 5000);
const Limits curves = limits(500, 5000, 1e5);

/// Steps until the axis rests, at most so many ticks; the furthest it went to either side.
struct Watched : Bench {
  explicit Watched(const AxisConfig& config) : Bench(config) { send(Kind::enable); }
  const Tick& rest(const Inputs& inputs = {}) {
    for (int i = 0; i < 20'000; ++i) {
      last = step({}, inputs);
      low = std::min(low, last.position);
      high = std::max(high, last.position);
      if (last.velocity == 0 && last.acceleration == 0 && last.progress == Progress::done) break;
    }
    return last;
  }
  Tick last;
  double low = INFINITY, high = -INFINITY;
};

// It moves down, but an acceleration upwards that only the jerk can end turns it round beyond the upper end: the
// stop comes back to that end. It went to the lower one, at full speed.
TEST(Range, AStopThatIsTurnedRoundRestsAtTheEndThatItPasses) {
  for (const double sign : {1.0, -1.0}) {
    const AxisConfig config = resolved(between(-300, 300, limits(500, 5000, 5e4)));
    MoveDynamics dynamics;
    ASSERT_FALSE(fill_stop(dynamics, config));
    const MotionState from{sign * 299.32, sign * -20, sign * 3000};
    const auto stop = plan(from, {Goal::Kind::rest, 0, dynamics}, 1, config);
    ASSERT_TRUE(stop);
    EXPECT_NEAR(stop->end().position, sign * 300, 1e-9);
    const auto [low, high] = positions(*stop);
    EXPECT_LT(high - low, 1);
  }
}

// It crept on at 1e-9 of its velocity.
TEST(Range, AJogThatBeginsJustBeforeTheLimitComesToRestThere) {
  for (const Limits& limits : {trapezoids, curves})
    for (const double room : {1e-6, 1e-5, 1e-4, 1e-3, 0.01, 0.1})
      for (const int late : {0, 30}) {
        Watched axis(between(-300, 300, limits));
        axis.step({command::SetPosition{.position = 300 - room}});
        axis.step({command::MoveVelocity{.velocity = 500}});
        axis.tick += late;
        const Tick tick = axis.run(200);
        EXPECT_EQ(tick.velocity, 0) << room << ' ' << late;
        EXPECT_EQ(tick.fault, Cause::positive_soft_limit);
        EXPECT_NEAR(tick.position, 300, 1e-9);
      }
}

// A stop is lost below, but the axis still moves up: it went down to the limit, slowly.
TEST(Range, AFaultThatMovesAwayFromTheLimitRestsWhereItIs) {
  Watched axis(between(-300, 300, curves));
  axis.step({command::SetPosition{.position = -295}});
  Gear gear(1, 1);
  axis.step({command::Couple{.movement = &gear}}, at_master(0, 5));
  for (int i = 1; i < 100; ++i) axis.step({}, at_master(5e-3 * i, 5));
  Inputs turns = at_master(0.5, 5);
  turns.master[2] = -9900;
  const Tick fault = axis.step({}, turns);
  EXPECT_EQ(fault.fault, Cause::negative_soft_limit);
  const Tick tick = axis.run(30);
  EXPECT_EQ(tick.velocity, 0);
  EXPECT_NEAR(tick.position, -294.5, 0.1);
}

// Issue 17, B2: it rested at 307.25.
TEST(Range, AMoveBlendsIntoAJogOnlyAsFastAsTheAxisCanStopInside) {
  for (const Limits& limits : {trapezoids, curves})
    for (const double sign : {1.0, -1.0})
      for (const double target : {299.0, 299.9999, 250.0, 300.0}) {
        Watched axis(between(-300, 300, limits));
        const MoveDynamics slow{.velocity = 500, .deceleration = 4000};
        axis.step({command::MoveAbsolute{.position = sign * target, .dynamics = slow}});
        const Tick jog = axis.step({command::MoveVelocity{
            .velocity = sign * 500, .buffer = BufferMode::blending_previous}});
        const Tick& tick = axis.rest();
        EXPECT_LE(axis.high, 300 + 1e-9);
        EXPECT_GE(axis.low, -300 - 1e-9);
        if (refusal(jog) == Cause::position_limit) continue;  // the target is the end of the range
        EXPECT_EQ(tick.fault, sign > 0 ? Cause::positive_soft_limit : Cause::negative_soft_limit);
        EXPECT_NEAR(tick.position, sign * 300, 1e-9);
      }
}

TEST(Range, AJogStopsAtTheLimitWithItsReason) {
  for (const Limits& limits : {trapezoids, curves})
    for (const double velocity : {500.0, 37.0, -500.0, -0.3}) {
      Watched axis(between(-1, 30, limits));
      axis.step({command::MoveVelocity{.velocity = velocity}});
      const Tick& tick = axis.rest();
      const Cause cause = velocity > 0 ? Cause::positive_soft_limit : Cause::negative_soft_limit;
      EXPECT_EQ(tick.fault, cause);
      EXPECT_EQ(tick.reason, cause);
      EXPECT_NEAR(tick.position, velocity > 0 ? 30 : -1, 1e-9);
      EXPECT_LE(axis.high, 30 + 1e-9);
      EXPECT_GE(axis.low, -1 - 1e-9);
      axis.send(Kind::reset);
      EXPECT_EQ(refusal(axis.step({command::MoveVelocity{.velocity = velocity}})),
                Cause::position_limit)
          << "it stands there";
      EXPECT_EQ(refusal(axis.step({command::MoveVelocity{.velocity = -velocity}})), Cause::none);
    }
}

// A move that reverses at the end of the range has no distance for a plain stop just before: a stop
// reverses, too.
TEST(Range, AStopBesideTheLimitStaysInside) {
  for (int when = 0; when < 200; ++when) {
    Watched axis(between(-300, 300, curves));
    axis.step({command::MoveAbsolute{.position = 300}});
    for (test::LoopLimit loop; axis.step().position < 200 && loop.goes_on();) continue;
    axis.step({command::MoveAbsolute{.position = 0}});
    for (int i = 0; i < when; ++i) axis.last = axis.step();
    axis.high = axis.last.position;
    axis.send(Kind::stop);
    const Tick& tick = axis.rest();
    ASSERT_EQ(tick.state, State::standstill);
    ASSERT_LE(axis.high, 300 + 1e-9) << when;
  }
}

// A cam-like table that reverses exactly at the end of the range, and any command that leaves it
// there.
TEST(Range, LeavingAPathAtItsTurningPointStaysInside) {
  AxisConfig config = between(0, 20, limits(500, 5000, 4e5));
  config.abort_acceleration = 3000;
  for (int when = 100; when < 200; ++when)
    for (const Kind kind : {Kind::abort, Kind::stop, Kind::halt, Kind::move_velocity}) {
      Watched axis(config);
      Job job(1, there_and_back(0, 20, 0.32, Extrapolation::wrap));
      axis.play(job, when);
      const Tick told =
          axis.step(any({.kind = kind, .position = kind == Kind::move_velocity ? -100.0 : 0.0}));
      axis.high = told.position;
      axis.rest();
      ASSERT_LE(axis.high, 20 + 1e-8) << name(kind) << " at " << when;
    }
}

TEST(Range, SlowStopsFollowersAndRowsAreStoppedAtTheLimit) {
  for (const Limits& limits : {trapezoids, curves}) {
    Watched halt(between(-300, 300, limits));
    halt.step({command::MoveVelocity{.velocity = 500}});
    halt.run(300);
    halt.step({command::Halt{.dynamics = {.deceleration = 100}}});
    EXPECT_NEAR(halt.rest().position, 300, 1e-9);
    EXPECT_LE(halt.high, 300 + 1e-9);

    Watched follower(between(-300, 300, limits));
    LiveGear gear(1, {.numerator = 1, .denominator = 1, .acceleration = 5000});
    double m = 0;
    follower.step({command::Couple{.movement = &gear}}, at_master(m, 400));
    for (int i = 0; i < 5000; ++i) {
      const Tick tick = follower.step({}, at_master(m += 0.4, 400));
      ASSERT_LE(tick.position, 300 + 1e-9);
      follower.last = tick;
    }
    EXPECT_EQ(follower.last.fault, Cause::positive_soft_limit);
    EXPECT_NEAR(follower.last.position, 300, 1e-9);
  }
}

/// The way up of the hardest turn, by small steps.
double stepped_turn(double v, double a, double s, double j) {
  constexpr double dt = 1e-6;
  double p = 0, most = 0;
  for (int i = 0; i < 10'000'000 && (v > 0 || a > 0); ++i) {
    const double next = std::max(a - j * dt, std::min(a, -s));
    p += v * dt + (a + next) * dt * dt / 4;
    v += (a + next) / 2 * dt;
    a = next;
    most = std::max(most, p);
  }
  return most;
}

// The ladder of stops against small steps of an integration: both agree.
TEST(Range, TheGentlestStopMatchesSmallSteps) {
  test::Random random(17);
  AxisConfig config = between(-1e6, 0, curves);
  config.limit_acceleration = 6000;
  const AxisConfig axis = resolved(config);
  int met[4] = {};
  for (int i = 0; i < 300; ++i) {
    const double v = random.uniform(-50, 500);
    const double a = random.uniform(-5000, 5000);
    const double way = stepped_turn(v, a, axis.stop_acceleration, axis.stop_jerk);
    if (way == 0) continue;
    const auto stop_at = [&](double p) { return gentlest_stop({p, v, a}, axis); };
    EXPECT_NE(stop_at(-way * (1 + 1e-3) - 1e-3), Stop::none) << v << ' ' << a;
    EXPECT_EQ(stop_at(-way * (1 - 1e-3) + 1e-3), Stop::none) << v << ' ' << a;
    for (const double more : {1.0, 1.02, 1.1, 1.3, 2.0, 4.0})
      ++met[static_cast<int>(stop_at(-way * more - 1e-3))];
    // The further away, the gentler.
    Stop before = Stop::none;
    for (double more = 0.5; more < 8; more *= 1.05) {
      const Stop now = stop_at(-way * more);
      EXPECT_LE(now, before);
      before = now;
    }
  }
  for (const Stop stop : {Stop::soft, Stop::hard, Stop::turning})
    EXPECT_GT(met[static_cast<int>(stop)], 0);
}

// Issue 17, B5: 15000 of 10000 and 1.5e6 of 1e6 where both speed up together.
TEST(Range, ASuperimposedMoveTakesWhatTheLimitsLeave) {
  const AxisConfig config{.limits = limits(1000, 10'000, 1e6)};
  const MoveDynamics below{
      .velocity = 600, .acceleration = 6000, .deceleration = 6000, .jerk = 6e5};
  for (int when = 0; when < 300; when += 7)
    for (const double distance : {20.0, -20.0}) {
      Bench axis(config);
      axis.send(Kind::enable);
      axis.step({command::MoveAbsolute{.position = 100, .dynamics = below}});
      Tick last = axis.run(when);
      if (last.state == State::standstill) break;
      ASSERT_EQ(refusal(axis.step({command::MoveSuperimposed{.distance = distance}})), Cause::none);
      for (int i = 0; i < 1500; ++i) {
        const Tick tick = axis.step();
        ASSERT_LE(std::abs(tick.velocity), 1000 * (1 + 1e-9));
        ASSERT_LE(std::abs(tick.acceleration), 10'000 * (1 + 1e-9)) << when << ' ' << i;
        const double change = i > 0 ? tick.acceleration - last.acceleration : 0;
        ASSERT_LE(std::abs(change), 1e6 * 1e-3 * (1 + 1e-6));
        last = tick;
      }
      EXPECT_NEAR(last.position, 100 + distance, 1e-6);
    }
  Bench full(config);
  full.send(Kind::enable);
  full.step({command::MoveAbsolute{.position = 100, .dynamics = {.velocity = 500}}});
  full.run(20);
  EXPECT_EQ(refusal(full.step({command::MoveSuperimposed{.distance = 1}})), Cause::no_reserve)
      << "the move below takes the whole acceleration";
}

TEST(Range, ASuperimposedMoveWithoutReserveNamesWhatTheMoveBelowUsesUp) {
  const AxisConfig config{.limits = limits(1000, 10'000, 1e6)};
  struct Case {
    double acceleration, deceleration, where;
  };
  for (const auto& [acceleration, deceleration, where] : {Case{5000, as_configured, 5},
                                                          {as_configured, 5000, 4},
                                                          {as_configured, as_configured, 2}}) {
    Bench bench(config);
    bench.send(Kind::enable);
    bench.step({command::MoveAbsolute{
        .position = 100,
        .dynamics = {
            .velocity = 500, .acceleration = acceleration, .deceleration = deceleration}}});
    bench.run(20);
    const Tick tick = bench.step({command::MoveSuperimposed{.distance = 1}});
    ASSERT_TRUE(tick.refused);
    EXPECT_EQ(tick.refused->cause, Cause::no_reserve);
    EXPECT_EQ(tick.refused->where, where);
    EXPECT_EQ(tick.refused->value, 10'000);
  }
}

}  // namespace
}  // namespace jounce::range_test
