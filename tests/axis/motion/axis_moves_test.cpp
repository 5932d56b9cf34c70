// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "jounce/axis/axis.hpp"

#include "axis/tables.hpp"

// The moves of PLCopen by the examples of the PMC600 manual, volume 4 (1.2 and 5.2.2, 5.2.4).

namespace jounce::axis_moves_test {
namespace {

using namespace test;

const AxisConfig pulses{.limits = limits(1e5, 1e6)};
const MoveDynamics brisk{.velocity = 3000, .acceleration = 10'000, .deceleration = 10'000};

struct Moves : Bench {
  explicit Moves(const AxisConfig& config = pulses) : Bench(config) { send(Kind::enable); }

  Tick move(Kind kind, double position, const MoveDynamics& dynamics = brisk) {
    const Tick now = step(any({.kind = kind, .position = position, .dynamics = dynamics}));
    EXPECT_FALSE(now.refused) << now.refused->text();
    return now;
  }
  /// Steps until this holds, and keeps every tick. Fails after 100 s.
  template <class Condition>
  const Tick& until(Condition condition) {
    for (int i = 0; i < 100'000; ++i) {
      ticks.push_back(step());
      if (condition(ticks.back())) return ticks.back();
    }
    ADD_FAILURE() << "the axis does not get there in 100 s";
    return ticks.back();
  }
  /// Steps to the end of the motion.
  const Tick& finish() {
    return until([](const Tick& t) { return t.state == State::standstill; });
  }
  std::vector<Tick> ticks;
};

// 1.2, Fig. 1.4 and 1.5: of two commands the last one wins. Here they are a tick apart.
TEST(AxisMoves, TheLastCommandWins) {
  Moves same;
  same.move(Kind::move_absolute, 1000);
  same.move(Kind::move_absolute, 2234);
  EXPECT_EQ(same.finish().position, 2234);
  Moves different;
  different.move(Kind::move_velocity, 3000);
  different.move(Kind::move_absolute, -5000);
  EXPECT_EQ(different.finish().position, -5000);
}

// Fig. 5.6: after Done; and in the constant phase of the first, which is then never stopped at.
TEST(AxisMoves, Figure56AbsoluteAfterAbsolute) {
  Moves after;
  after.move(Kind::move_absolute, 6000);
  EXPECT_EQ(after.finish().position, 6000);
  EXPECT_EQ(after.ticks.back().finished, 1U);
  after.move(Kind::move_absolute, 10'000);
  EXPECT_EQ(after.finish().position, 10'000);

  Moves instead;
  instead.move(Kind::move_absolute, 6000);
  instead.until([](const Tick& t) { return t.velocity == 3000; });
  EXPECT_EQ(instead.move(Kind::move_absolute, 10'000).reason, Cause::replaced);
  const std::size_t replaced = instead.ticks.size();
  instead.until([](const Tick& t) { return t.position >= 9000; });
  for (std::size_t i = replaced; i < instead.ticks.size(); ++i)
    ASSERT_NEAR(instead.ticks[i].velocity, 3000, 1e-9);
  EXPECT_EQ(instead.finish().position, 10'000);
  EXPECT_EQ(instead.ticks.back().finished, 1U);
}

// Fig. 5.7: the second relative move counts from where the first was interrupted.
TEST(AxisMoves, Figure57RelativeAfterRelative) {
  Moves after;
  after.move(Kind::move_relative, 6000);
  after.finish();
  after.move(Kind::move_relative, 4000);
  EXPECT_EQ(after.finish().position, 10'000);

  Moves instead;
  instead.move(Kind::move_relative, 6000, {.velocity = 2500, .acceleration = 10'000});
  const Tick at = instead.until([](const Tick& t) { return t.position >= 3250; });
  instead.move(Kind::move_relative, 4000);
  EXPECT_DOUBLE_EQ(instead.finish().position, at.position + 4000);
  EXPECT_NEAR(at.position, 3250, 2.5);  // a tick's way
}

// Fig. 5.8: from 3000 to 2000, once the first is in velocity and before it is.
TEST(AxisMoves, Figure58VelocityAfterVelocity) {
  for (const double when : {3000.0, 2500.0}) {
    Moves moves;
    EXPECT_EQ(moves.move(Kind::move_velocity, 3000).state, State::continuous_motion);
    moves.until([&](const Tick& t) { return t.velocity >= when; });
    moves.move(Kind::move_velocity, 2000, {.deceleration = 10'000});
    const Tick slow = moves.run(1000);
    EXPECT_EQ(slow.velocity, 2000);
    EXPECT_EQ(slow.state, State::continuous_motion);
    const Tick later = moves.run(5000);
    EXPECT_NEAR(later.position - slow.position, 10'000, 1e-8);
  }
}

// Fig. 5.9: nothing interrupts a stop.
TEST(AxisMoves, Figure59StopLocks) {
  Moves moves;
  moves.move(Kind::move_velocity, 3000);
  moves.run(1000);
  const Tick first = moves.step({command::Stop{.dynamics = {.deceleration = 10'000}}});
  EXPECT_EQ(first.state, State::stopping);
  for (const Kind kind : {Kind::move_absolute, Kind::move_velocity, Kind::halt, Kind::hold})
    EXPECT_EQ(refusal(moves.send(kind)), Cause::stopping);
  // v^2 / 2a = 450 and v / a = 0.3 s from the tick before; the first tick has moved 2.995.
  const Tick rest = moves.until([](const Tick& t) { return t.velocity == 0; });
  EXPECT_EQ(rest.tick - first.tick, 299);
  EXPECT_NEAR(rest.position - first.position, 450 - 2.995, 1e-9);
  const Tick tick = moves.step();
  EXPECT_EQ(tick.state, State::standstill);
  EXPECT_EQ(tick.reason, Cause::stopped);
  EXPECT_EQ(tick.stopped, 1U);
}

// Fig. 5.10: a halt may be interrupted before zero; the axis speeds up from there.
TEST(AxisMoves, Figure510HaltMayBeInterrupted) {
  Moves moves;
  moves.move(Kind::move_velocity, 3000);
  moves.run(1000);
  moves.step({command::Halt{.dynamics = {.deceleration = 10'000}}});
  const Tick slow = moves.until([](const Tick& t) { return t.velocity < 1500; });
  EXPECT_GT(slow.velocity, 0);
  EXPECT_GT(moves.move(Kind::move_velocity, 3000).velocity, slow.velocity);
  EXPECT_EQ(moves.run(1000).velocity, 3000);
  moves.send(Kind::halt);
  moves.run(1000);
  const Tick rest = moves.step();
  EXPECT_EQ(rest.state, State::standstill);
  EXPECT_EQ(rest.reason, Cause::halted);
}

// Fig. 5.11: 6000 and an additive 4000, after Done and from 4000 on: both end at 10000.
TEST(AxisMoves, Figure511AdditiveKeepsTheTarget) {
  Moves after;
  after.move(Kind::move_absolute, 6000);
  after.finish();
  after.move(Kind::move_additive, 4000);
  EXPECT_EQ(after.finish().position, 10'000);
  Moves during;
  during.move(Kind::move_absolute, 6000);
  during.until([](const Tick& t) { return t.position >= 4000; });
  during.move(Kind::move_additive, 4000);
  EXPECT_EQ(during.finish().position, 10'000);
  // After a velocity command: the distance, then rest.
  Moves velocity;
  velocity.move(Kind::move_velocity, 3000);
  const double from = velocity.run(1000).position;
  velocity.move(Kind::move_additive, 4000);
  EXPECT_DOUBLE_EQ(velocity.finish().position, from + 4000);
}

// Fig. 5.12: a superimposed move leaves the one below alone; the velocities add up meanwhile.
TEST(AxisMoves, Figure512SuperimposedAddsUp) {
  const MoveDynamics above{.velocity = 500, .acceleration = 5000, .deceleration = 5000};
  Moves moves;
  moves.move(Kind::move_relative, 6000);
  moves.until([](const Tick& t) { return t.velocity == 3000; });
  EXPECT_EQ(moves.move(Kind::move_superimposed, 1000, above).state, State::discrete_motion);
  EXPECT_EQ(moves.run(500).velocity, 3500);
  EXPECT_NEAR(moves.finish().position, 7000, 1e-9);
  EXPECT_EQ(moves.ticks.back().reason, Cause::none);

  // Begun late it outlasts the other one, and runs on alone at its own velocity.
  Moves late;
  late.move(Kind::move_relative, 6000);
  late.until([](const Tick& t) { return t.position > 5700; });
  late.move(Kind::move_superimposed, 1000, above);
  const Tick alone = late.until([](const Tick& t) { return t.velocity <= 500; });
  EXPECT_EQ(alone.state, State::discrete_motion);
  EXPECT_NEAR(late.run(500).velocity, 500, 1e-9);
  EXPECT_NEAR(late.finish().position, 7000, 1e-9);
}

// Fig. 5.16: 50000 at 10000 with 1e5; at 2 s to 100000 at 20000 with 2e5: at 19500 then, and at the
// target after 6.0875 s.
TEST(AxisMoves, Figure516ChangesTargetAndVelocity) {
  Moves moves;
  moves.move(Kind::move_absolute, 50'000,
             {.velocity = 10'000, .acceleration = 1e5, .deceleration = 1e5});
  const std::int64_t start = moves.tick;
  EXPECT_NEAR(moves.run(2000).position, 19'500, 1e-8);
  moves.move(Kind::move_absolute, 100'000,
             {.velocity = 20'000, .acceleration = 2e5, .deceleration = 2e5});
  EXPECT_EQ(moves.finish().position, 100'000);
  EXPECT_EQ(moves.tick - start, 6088);  // the first tick after it
}

// Fig. 5.17: +10000, at 2 s -20000: it turns round.
TEST(AxisMoves, Figure517TurnsRound) {
  Moves moves;
  const MoveDynamics forth{.acceleration = 1e5, .deceleration = 1e5};
  const MoveDynamics back{.acceleration = 1e5, .deceleration = 1e5};
  moves.move(Kind::move_velocity, 10'000, forth);
  EXPECT_EQ(moves.run(2000).velocity, 10'000);
  moves.move(Kind::move_velocity, -20'000, back);
  EXPECT_EQ(moves.run(301).velocity, -20'000);
}

TEST(AxisMoves, WhatIsNotGivenIsTheLimitAndBeyondItIsRejected) {
  Moves moves;
  moves.move(Kind::move_velocity, -1e5, {});
  EXPECT_EQ(moves.run(200).velocity, -1e5);
  const auto refused = [&](const MoveDynamics& d, double to = 1) {
    return refusal(moves.step({command::MoveAbsolute{.position = to, .dynamics = d}}));
  };
  EXPECT_EQ(refused({.velocity = 1.1e5}), Cause::velocity_limit);
  EXPECT_EQ(refused({.acceleration = 1.1e6}), Cause::acceleration_limit);
  EXPECT_EQ(refused({.deceleration = 1.1e6}), Cause::acceleration_limit);
  EXPECT_EQ(refused({.velocity = INFINITY}), Cause::velocity_limit);
  EXPECT_EQ(refused({.velocity = -1}), Cause::not_positive);
  EXPECT_EQ(refused({}, NAN), Cause::no_value);
  EXPECT_EQ(moves.step().velocity, -1e5) << "refused commands change nothing";
}

// A joystick at its center: -0 is 0, and neither is a direction or a limit.
TEST(AxisMoves, AJogAtZeroIsRest) {
  for (const double zero : {0.0, -0.0}) {
    Moves standing;
    EXPECT_EQ(standing.move(Kind::move_velocity, zero, {}).velocity, 0);
    EXPECT_EQ(standing.run(10).position, 0);
    EXPECT_EQ(standing.step().state, State::standstill);
    for (const double velocity : {3000.0, -3000.0}) {
      Moves moves;
      moves.move(Kind::move_velocity, velocity, {});
      moves.run(100);
      moves.move(Kind::move_velocity, zero, {});
      const Tick& rest = moves.finish();
      EXPECT_EQ(rest.velocity, 0);
      EXPECT_EQ(rest.reason, Cause::none);
      EXPECT_EQ(rest.finished, 1U);
      EXPECT_EQ(moves.send(Kind::set_position).state, State::standstill);
    }
  }
}

TEST(AxisMoves, AJogAtZeroIsNoDirection) {
  Inputs on;
  on.positive_switch = on.negative_switch = true;
  for (const double zero : {0.0, -0.0}) {
    Moves moves;
    EXPECT_EQ(refusal(moves.step({command::MoveVelocity{.velocity = zero}}, on)), Cause::none);
  }
  Moves moves;
  EXPECT_EQ(refusal(moves.step({command::MoveVelocity{.velocity = -1.1e5}})),
            Cause::velocity_limit);
}

TEST(AxisMoves, ADynamicsOfZeroIsRejected) {
  const std::vector<double MoveDynamics::*> all{&MoveDynamics::velocity,
                                                &MoveDynamics::acceleration,
                                                &MoveDynamics::deceleration, &MoveDynamics::jerk};
  for (const Kind kind : {Kind::move_absolute, Kind::move_relative, Kind::move_additive,
                          Kind::move_superimposed, Kind::move_velocity, Kind::halt, Kind::stop})
    for (double MoveDynamics::*const value : all)
      for (const double zero : {0.0, -0.0}) {
        const bool stops = kind == Kind::halt || kind == Kind::stop;
        if (kind == Kind::move_velocity && value == all[0]) continue;  // it has none
        if (stops && (value == all[0] || value == all[1])) continue;
        Moves moves;
        moves.move(Kind::move_absolute, 6000);
        moves.run(100);
        AnyCommand command{.kind = kind, .position = 10};
        command.dynamics.*value = zero;
        const Tick now = moves.step(command);
        EXPECT_EQ(refusal(now), Cause::not_positive) << name(kind);
        EXPECT_EQ(now.state, State::discrete_motion) << "the move goes on";
      }
}

TEST(AxisMoves, OverrideScalesTheVelocityAndHoldIsNone) {
  Moves moves;
  moves.move(Kind::move_absolute, 10'000);
  moves.run(1000);
  moves.step({command::Override{.factor = 0.5}});
  EXPECT_EQ(moves.run(500).velocity, 1500);
  moves.send(Kind::hold);
  Tick held = moves.run(500);
  EXPECT_EQ(held.velocity, 0);
  EXPECT_EQ(held.state, State::discrete_motion);
  EXPECT_EQ(moves.run(500).position, held.position);
  moves.send(Kind::resume);
  EXPECT_EQ(moves.run(500).velocity, 1500);
  moves.step({command::Override{.factor = 1}});
  EXPECT_EQ(moves.finish().position, 10'000);
  EXPECT_EQ(moves.ticks.back().finished, 1U);
  EXPECT_EQ(refusal(moves.step({command::Override{.factor = 2.01}})), Cause::no_value);
}

TEST(AxisMoves, AModuloAxisMovesInTheRequestedDirection) {
  AxisConfig config{.limits = limits(720, 7200), .modulo = 360};
  const auto end = [&](double from, double to, Direction direction) {
    config.position = from;
    Moves moves(config);
    moves.step({command::MoveAbsolute{.position = to, .direction = direction}});
    return moves.finish().position;
  };
  EXPECT_NEAR(end(350, 10, Direction::shortest), 370, 1e-9);
  EXPECT_NEAR(end(350, 10, Direction::negative), 10, 1e-9);
  EXPECT_NEAR(end(10, 350, Direction::positive), 350, 1e-9);
  EXPECT_NEAR(end(10, 350, Direction::shortest), -10, 1e-9);
}

TEST(AxisMoves, AMoveTakesOverFromATableWithoutALeap) {
  Job job(1, trapezoid_table(50, 10, 20, 20));
  Bench bench({.limits = limits(10, 20)});
  bench.play(job);
  Tick last = bench.run(250);  // 5 u/s, 20 u/s^2
  Tick tick = bench.step({command::MoveAbsolute{.position = -1}});
  EXPECT_EQ(tick.handed_back[0], &job);
  for (int i = 0; i < 100'000 && tick.state == State::discrete_motion; ++i) {
    ASSERT_LE(std::abs(tick.velocity - last.velocity), 0.02 * (1 + 1e-9));
    ASSERT_NEAR(tick.position - last.position, (tick.velocity + last.velocity) / 2e3, 1e-5);
    last = tick;
    tick = bench.step();
  }
  EXPECT_EQ(tick.state, State::standstill);
  EXPECT_EQ(tick.position, -1);
}

TEST(AxisMoves, TargetsBeyondTheRangeAreRejected) {
  AxisConfig config = pulses;
  config.limits.position_max = 5000;
  Moves moves(config);
  const Tick tick = moves.step({command::MoveAbsolute{.position = 5001}});
  EXPECT_EQ(refusal(tick), Cause::position_limit);
  EXPECT_EQ(tick.refused->limit, 5000);
  moves.move(Kind::move_absolute, 5000);
  EXPECT_EQ(moves.finish().position, 5000);
}

}  // namespace
}  // namespace jounce::axis_moves_test
