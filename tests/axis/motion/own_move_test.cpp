// SPDX-License-Identifier: Apache-2.0
#include "axis/src/motion/own_move.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "axis/bench.hpp"

namespace jounce::own_move_test {
namespace {

using namespace test;

const AxisConfig axis = resolved({.limits = limits(100, 1000)});

/// A move from 0 to 50 u that began in tick 0: 0.6 s, of which 0.4 s at 100 u/s.
struct Moving {
  Moving() { EXPECT_TRUE(move.plan(from, to(50), 1, at(0))); }

  static Goal to(double position) {
    Goal goal{Goal::Kind::position, position};
    EXPECT_FALSE(fill(goal.dynamics, axis));
    return goal;
  }
  MoveConditions at(std::int64_t tick) const {
    return {.tick = tick, .last_tick = tick - 1, .rules = axis, .rate = rate};
  }
  std::optional<Refusal> buffer(double position, BufferMode mode) {
    return move.buffer(command::MoveAbsolute{.position = position, .buffer = mode},
                       MotionState{50, 0, 0}, {0, 0, 0}, &from, at(0));
  }

  double rate = 1;
  TimedState from{{0, 0, 0}, 0};
  OwnMove move{axis};
};

TEST(OwnMove, PassesItsTargetOnlyWhileAMoveWaitsThere) {
  Moving axis_;
  OwnMove& move = axis_.move;
  EXPECT_FALSE(move.passes());
  EXPECT_FALSE(axis_.buffer(80, BufferMode::blending_next));
  EXPECT_TRUE(move.passes());
  EXPECT_GT(move.player().plan().end().velocity, 0);
  EXPECT_TRUE(move.withdraw(&axis_.from, axis_.at(0)));
  EXPECT_TRUE(move.waiting().empty());
  EXPECT_FALSE(move.passes());
  EXPECT_EQ(move.player().plan().end().velocity, 0);
}

TEST(OwnMove, AWithdrawalThatIsTooLateChangesNothing) {
  Moving axis_;
  axis_.buffer(80, BufferMode::blending_next);
  const TimedState late{{49.9, 100, 0}, 500};  // 100 u/s needs 5 u to stop
  AxisConfig narrow = axis;
  narrow.limits.position_max = 50.5;
  MoveConditions now{.tick = 500, .last_tick = 499, .rules = narrow};
  EXPECT_FALSE(axis_.move.withdraw(&late, now));
  EXPECT_EQ(axis_.move.waiting().size(), 1U);
  EXPECT_TRUE(axis_.move.passes());
}

TEST(OwnMove, ASuperimposedMoveEndsTheBlendAtRest) {
  Moving axis_;
  MoveConditions now = axis_.at(0);
  now.shifted = true;
  EXPECT_FALSE(
      axis_.move.buffer(command::MoveAbsolute{.position = 80, .buffer = BufferMode::blending_next},
                        MotionState{50, 0, 0}, {}, &axis_.from, now));
  EXPECT_FALSE(axis_.move.passes());
}

TEST(OwnMove, ALateTickPassesSeveralTargets) {
  Moving axis_;
  for (const double target : {60.0, 70.0, 500.0})
    EXPECT_FALSE(axis_.buffer(target, BufferMode::blending_next));
  EXPECT_EQ(axis_.move.advance(axis_.at(540)).passed, 0);
  const OwnMove::Step step = axis_.move.advance(axis_.at(800));
  EXPECT_EQ(step.passed, 3);
  EXPECT_EQ(step.fault, Cause::none);
  EXPECT_EQ(axis_.move.goal().value, 500);
  EXPECT_NEAR(axis_.move.player().at(800)[1], 100, 1e-6);
}

TEST(OwnMove, AtMostEightMovesWait) {
  Moving axis_;
  for (int i = 0; i < 8; ++i) EXPECT_FALSE(axis_.buffer(60 + i, BufferMode::buffered));
  EXPECT_EQ(axis_.buffer(70, BufferMode::buffered)->cause, Cause::buffer_full);
  const WaitingMoves all = axis_.move.take_all();
  EXPECT_EQ(replaced(all)->cause, Cause::replaced);
  EXPECT_EQ(replaced(all)->value, 60);
  EXPECT_FALSE(replaced(axis_.move.waiting()));
  axis_.move.keep(all);
  EXPECT_EQ(value_of(axis_.move.take_next()), 60);
  EXPECT_EQ(axis_.move.waiting().size(), 7U);
}

TEST(OwnMove, BeginsEachStrokeAfterItsRest) {
  Moving axis_;
  OwnMove& move = axis_.move;
  const command::MoveRepetitive what{.position = 50, .wait = 0.1, .strokes = 2};
  Goal there;
  ASSERT_FALSE(move.first_stroke(what, {0, 0, 0}, axis_.at(0), there));
  move.repeat(what, 0);
  EXPECT_TRUE(move.repeats());
  move.advance(axis_.at(690));
  EXPECT_EQ(move.goal().value, 50);
  move.advance(axis_.at(710));
  EXPECT_EQ(move.goal().value, 0);
  EXPECT_TRUE(move.is_stroke());
  EXPECT_FALSE(move.repeats()) << "it was the last one";
  move.forget_changes();
  EXPECT_FALSE(move.is_stroke());
}

TEST(OwnMove, AHeldMoveBeginsNoStrokeAndNoChange) {
  Moving axis_;
  axis_.move.repeat({.position = 50, .wait = 0, .strokes = 0}, 0);
  axis_.rate = 0;
  axis_.move.advance(axis_.at(700));
  EXPECT_EQ(axis_.move.goal().value, 50);
}

TEST(OwnMove, ChangesItsVelocityWhereItPassesAPosition) {
  Moving axis_;
  OwnMove& move = axis_.move;
  EXPECT_FALSE(move.change({.velocity = 50, .position = 20}, axis_.from, axis_.at(0)));
  EXPECT_TRUE(move.changes_later());
  move.advance(axis_.at(100));
  EXPECT_TRUE(move.changes_later());
  std::int64_t tick = 100;
  while (move.changes_later() && tick < 600) move.advance(axis_.at(++tick));
  EXPECT_EQ(tick, 250) << "5 u in 0.1 s, then 15 u at 100 u/s";
  EXPECT_EQ(move.goal().dynamics.velocity, 50);
  EXPECT_NEAR(move.player().at(350)[1], 50, 1e-9);
}

TEST(OwnMove, RejectsAChangeThatTheSuperimposedMoveLeftNoRoomFor) {
  Moving axis_;
  MoveConditions now = axis_.at(0);
  axis_.move.change({.velocity = 50, .position = NAN}, axis_.from, now);
  now.added = true;
  EXPECT_EQ(axis_.move.change({.velocity = 60, .position = NAN}, axis_.from, now)->cause,
            Cause::in_motion);
  EXPECT_FALSE(axis_.move.change({.velocity = 40, .position = NAN}, axis_.from, now));
  EXPECT_EQ(axis_.move.change({.velocity = 101, .position = NAN}, axis_.from, now)->cause,
            Cause::velocity_limit);
}

}  // namespace
}  // namespace jounce::own_move_test
