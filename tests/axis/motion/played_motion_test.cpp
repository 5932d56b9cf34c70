// SPDX-License-Identifier: Apache-2.0
#include "axis/src/motion/played_motion.hpp"

#include <gtest/gtest.h>

#include "axis/model/model_movements.hpp"
#include "axis/src/motion/motion_rules.hpp"
#include "axis/tables.hpp"

namespace jounce::played_motion_test {
namespace {

using namespace test;
using Ending = PlayedMotion::Ending;

const AxisConfig axis = resolved({.limits = limits(100, 1000)});

ArmedMotion armed(Movement& movement) {
  ArmedMotion slot;
  slot.arm(&movement, 0);
  slot.accept(StartAt::tick, 10, 0, 10);
  return slot;
}

/// A motion at tick 10 and the path there and back: 20 u in 1 s each way.
struct Playing {
  MotionNow at(std::int64_t tick, const MotionState& last = {}) const {
    return {
        .tick = tick, .last_tick = tick - 1, .last = last, .moment = {.dt = 1e-3}, .rules = axis};
  }
  void play_path() { motion.begin_path(armed(job), 0, at(10)); }
  void play_gear() {
    EXPECT_EQ(gear.begin({}, {.master = {5, 0, 0, 0}}), Cause::none);
    motion.begin_live(armed(gear), at(10));
  }
  void play_move(double position) {
    Goal goal{Goal::Kind::position, position};
    fill(goal.dynamics, axis);
    EXPECT_TRUE(motion.plan(goal, 1, at(10)));
    motion.begin_move({});
    motion.begin_at(10);
  }

  Job job{1, there_and_back(0, 20, 2, Extrapolation::hold)};
  Gear gear{2, 1};
  PlayedMotion motion{axis};
};

TEST(PlayedMotion, OnePlayerAtMostGivesTheSetpoints) {
  Playing playing;
  PlayedMotion& motion = playing.motion;
  const auto kinds = [&] {
    return motion.on_path() + motion.is_live() + motion.is_move() + motion.in_group();
  };
  EXPECT_EQ(kinds(), 0);
  playing.play_path();
  EXPECT_EQ(kinds(), 1);
  EXPECT_EQ(motion.movement(), &playing.job);
  EXPECT_EQ(motion.end_movement(), &playing.job);
  EXPECT_EQ(motion.movement(), nullptr);
  playing.play_gear();
  EXPECT_EQ(kinds(), 1);
  EXPECT_TRUE(motion.follows_master());
  EXPECT_EQ(motion.movement(), &playing.gear);
  motion.end_movement();
  playing.play_move(50);
  EXPECT_EQ(kinds(), 1);
  EXPECT_EQ(motion.movement(), nullptr);
  motion.rest();
  motion.begin_group(11);
  EXPECT_EQ(kinds(), 1);
  EXPECT_TRUE(motion.in_group());
}

TEST(PlayedMotion, AHeldMotionAndOneThatEndsRequestTheRate0) {
  Playing playing;
  PlayedMotion& motion = playing.motion;
  EXPECT_TRUE(motion.set_factor(1.5, playing.at(9)));
  EXPECT_EQ(motion.requested_rate(false), 1.5);
  EXPECT_EQ(motion.requested_rate(true), 1) << "a homing is not faster than its velocities";
  playing.play_path();
  EXPECT_TRUE(motion.hold(true, playing.at(10)));
  EXPECT_EQ(motion.requested_rate(false), 0);
  EXPECT_TRUE(motion.hold(false, playing.at(10)));
  EXPECT_EQ(motion.requested_rate(false), 1.5);
  motion.end_by(Ending::halt);
  EXPECT_TRUE(motion.ends());
  EXPECT_EQ(motion.requested_rate(false), 0);
  EXPECT_EQ(motion.request(11, false, nullptr).rate, 0);
  EXPECT_TRUE(motion.conditions(playing.at(11)).stopping);
}

TEST(PlayedMotion, ANewMovementIsNeitherHeldNorEnds) {
  Playing playing;
  PlayedMotion& motion = playing.motion;
  playing.play_path();
  motion.hold(true, playing.at(10));
  motion.end_by(Ending::fault);
  motion.end_movement();
  playing.play_gear();
  EXPECT_FALSE(motion.held());
  EXPECT_FALSE(motion.ends());
  EXPECT_EQ(motion.begun(), 10);
}

TEST(PlayedMotion, AStopInAFaultGoesOnHeld) {
  Playing playing;
  PlayedMotion& motion = playing.motion;
  motion.end_by(Ending::fault);
  motion.go_on_held();
  EXPECT_FALSE(motion.held()) << "at rest there is nothing to hold";
  playing.play_path();
  motion.end_by(Ending::fault);
  EXPECT_FALSE(motion.brakes_in_fault()) << "it stops on its path";
  motion.go_on_held();
  EXPECT_TRUE(motion.held());
  EXPECT_FALSE(motion.ends());
}

TEST(PlayedMotion, AFactorThatAMoveCannotTakeChangesNothing) {
  Playing playing;
  PlayedMotion& motion = playing.motion;
  playing.play_move(50);
  AxisConfig narrow = axis;  // the move from 49 u at 100 u/s cannot stop inside
  narrow.limits.position_min = 0;
  narrow.limits.position_max = 50;
  motion.put_out({49.9, 100, 0}, 20);
  const MotionNow now{
      .tick = 21, .last_tick = 20, .last = {49.9, 100, 0}, .moment = {.dt = 1e-3}, .rules = narrow};
  EXPECT_FALSE(motion.set_factor(0.5, now));
  EXPECT_EQ(motion.factor(), 1);
  EXPECT_FALSE(motion.ends());
}

TEST(PlayedMotion, ASuperimposedMoveEndsWithItsMotion) {
  Playing playing;
  PlayedMotion& motion = playing.motion;
  playing.play_move(50);
  EXPECT_TRUE(motion.superimpose(5, {}, playing.at(10))) << "the move needs all of the velocity";
  motion.rest();
  EXPECT_TRUE(motion.set_factor(0.5, playing.at(10)));
  playing.play_path();
  EXPECT_FALSE(motion.superimpose(5, {}, playing.at(10)));
  EXPECT_TRUE(motion.above().running());
  EXPECT_EQ(motion.expected_end(0)->position, 5);
  EXPECT_FALSE(motion.unplayed(0));
  motion.rest();
  EXPECT_FALSE(motion.above().running());
  EXPECT_EQ(motion.expected_end(3)->position, 3);
}

TEST(PlayedMotion, OnlyAMotionThatWasCheckedAsAWholeIsBounded) {
  Playing playing;
  PlayedMotion& motion = playing.motion;
  playing.play_gear();
  EXPECT_FALSE(motion.supervised(0, playing.at(10)).bounded);
  motion.end_movement();
  playing.play_move(50);
  EXPECT_TRUE(motion.supervised(0, playing.at(10)).bounded);
  motion.hold(true, playing.at(10));
  EXPECT_FALSE(motion.supervised(0, playing.at(10)).bounded) << "it brakes elsewhere";
  motion.begin_tick();
  EXPECT_FALSE(motion.supervised(0, playing.at(10)).joined);
  motion.join();
  EXPECT_TRUE(motion.supervised(0, playing.at(10)).joined);
}

// ---- the rules -----------------------------------------------------------------------------------

TEST(MotionRules, APathBeginsOnlyFromRestOrFromAPath) {
  Playing playing;
  PlayedMotion& motion = playing.motion;
  Job next(3, there_and_back(0, 5, 1, Extrapolation::hold));
  const ArmedMotion slot = armed(next);
  const command::Start now{};
  EXPECT_FALSE(against_start(now, slot, motion, playing.at(10)));
  playing.play_move(50);
  EXPECT_EQ(against_start(now, slot, motion, playing.at(11))->cause, Cause::in_motion);
  EXPECT_FALSE(against_start(now, armed(playing.gear), motion, playing.at(11)))
      << "a coupling may take over in motion";
  EXPECT_EQ(against_start_at_end(slot, motion, playing.at(11), axis)->cause, Cause::not_on_path);
  motion.rest();
  playing.play_path();
  EXPECT_FALSE(against_start_at_end(slot, motion, playing.at(11), axis));
  EXPECT_EQ(against_start({.when = StartAt::tick, .tick = 5}, slot, motion, playing.at(11))->cause,
            Cause::too_late);
}

TEST(MotionRules, OnlyARepeatingPathThatPassesItsEndAtRestFinishes) {
  Playing playing;
  EXPECT_EQ(against_finish(playing.motion, axis)->cause, Cause::not_on_path);
  playing.play_path();
  EXPECT_FALSE(against_finish(playing.motion, axis)) << "it ends by itself";
  playing.motion.end_by(Ending::halt);
  EXPECT_EQ(against_finish(playing.motion, axis)->cause, Cause::halting);
}

TEST(MotionRules, AMoveRestsAtItsTargetAndGoesOnWhileItIsHeld) {
  Playing playing;
  PlayedMotion& motion = playing.motion;
  playing.play_move(50);
  const auto sequel = [&](std::int64_t tick) { return sequel_of(motion, {.tick = tick}); };
  EXPECT_EQ(sequel(600), Sequel::goes_on);
  EXPECT_EQ(sequel(611), Sequel::rests);
  EXPECT_EQ(reason_to_rest(motion, Cause::none), Cause::none);
  motion.hold(true, playing.at(10));
  EXPECT_EQ(sequel(5000), Sequel::goes_on);
  motion.end_by(Ending::halt);
  EXPECT_EQ(sequel(5000), Sequel::rests);
  EXPECT_EQ(reason_to_rest(motion, Cause::none), Cause::halted);
  motion.end_by(Ending::fault);
  EXPECT_EQ(reason_to_rest(motion, Cause::watchdog), Cause::watchdog);
}

TEST(MotionRules, AnAxisOfAGroupRestsWithItsGroup) {
  Playing playing;
  playing.motion.begin_group(10);
  EXPECT_EQ(sequel_of(playing.motion, {.tick = 11, .peers = Peers::led}), Sequel::goes_on);
  EXPECT_EQ(sequel_of(playing.motion, {.tick = 11, .peers = Peers::landing}), Sequel::rests);
}

}  // namespace
}  // namespace jounce::played_motion_test
