// SPDX-License-Identifier: Apache-2.0
#include "jounce/profiles/sequences/queue.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

#include <gtest/gtest.h>

#include "jounce/profiles/curve/extrema.hpp"
#include "jounce/profiles/error.hpp"
#include "jounce/profiles/limits/limits.hpp"
#include "jounce/profiles/moves/dynamics.hpp"

#include "support/invariants.hpp"
#include "support/random.hpp"

namespace jounce::queue_test {
namespace {

constexpr BufferMode blending[] = {BufferMode::blending_low, BufferMode::blending_previous,
                                   BufferMode::blending_next, BufferMode::blending_high};

Dynamics dynamics(double velocity, double acceleration, double deceleration = 0, double jerk = 0) {
  return {velocity, acceleration, deceleration, jerk, 0};
}

QueuedCommand aborting(const MotionCommand& command, const Dynamics& d, double issued) {
  return {command, d, BufferMode::aborting, issued};
}

// ---- the controllers' manuals -------------------------------------------------------------------

TEST(Queue, Pmc600Fig521PassesTheJointAtFiveThousand) {
  for (const auto mode : {BufferMode::blending_low, BufferMode::blending_previous}) {
    const QueuedMotion m =
        queue({.commands = {{MoveAbsolute{10000}, dynamics(5000, 10000)},
                            {MoveAbsolute{50000}, dynamics(20000, 20000), mode}}});
    EXPECT_DOUBLE_EQ(m.commands[0].end, 2.25);
    EXPECT_EQ(m.commands[0].reached, 5000);
    EXPECT_EQ(m.trajectory.at(m.commands[0].end).position, 10000);
    EXPECT_DOUBLE_EQ(m.trajectory.end(), 5.03125);
    EXPECT_EQ(m.end.position, 50000);
  }
}

TEST(Queue, Pmc600Fig516ChangesTargetAndVelocityInTheMiddle) {
  const QueuedMotion m =
      queue({.commands = {{MoveAbsolute{50000}, dynamics(10000, 100000)},
                          aborting(MoveAbsolute{100000}, dynamics(20000, 200000), 2)}});
  EXPECT_DOUBLE_EQ(m.trajectory.at(2).position, 19500);
  EXPECT_DOUBLE_EQ(m.trajectory.end(), 6.0875);
  EXPECT_EQ(m.commands[0].state, CommandState::aborted);
  EXPECT_EQ(m.commands[1].state, CommandState::done);
  EXPECT_EQ(m.end.position, 100000);
}

TEST(Queue, Pmc600Fig517TurnsRound) {
  const QueuedMotion m =
      queue({.commands = {{MoveVelocity{}, dynamics(10000, 100000)},
                          aborting(MoveAbsolute{-20000}, dynamics(10000, 100000), 2)}});
  EXPECT_EQ(m.end, (MotionState{-20000, 0, 0}));
  // 0.1 s and 500 to a stop, from 20000 there and back with ramps of 0.1 s.
  EXPECT_DOUBLE_EQ(m.trajectory.end(), 2 + 0.1 + 0.1 + (19500 + 500 + 20000) / 10000.0);
}

TEST(Queue, Pmc600Fig57RelativeMovesAddUpOrBeginWhereTheyAbort) {
  const Dynamics d = dynamics(1000, 2000);
  const QueuedMotion both = queue({.commands = {{MoveRelative{6000}, d}, {MoveRelative{4000}, d}}});
  EXPECT_EQ(both.commands[0].target, 6000);
  EXPECT_EQ(both.end.position, 10000);
  const double at_3250 = 0.5 + (3250 - 250) / 1000.0;
  const QueuedMotion cut =
      queue({.commands = {{MoveRelative{6000}, d}, aborting(MoveRelative{4000}, d, at_3250)}});
  EXPECT_DOUBLE_EQ(cut.end.position, 7250);
}

TEST(Queue, Pmc600Fig58SlowsFromThreeThousandToTwo) {
  for (const double issued : {5.0, 1.0}) {  // once in velocity, and before
    const QueuedMotion m =
        queue({.commands = {{MoveVelocity{}, dynamics(3000, 1000, 500)},
                            aborting(MoveVelocity{}, dynamics(2000, 1000, 500), issued)}});
    EXPECT_EQ(m.commands[0].state, issued < 3 ? CommandState::aborted : CommandState::done);
    EXPECT_EQ(m.end.velocity, 2000);
    EXPECT_DOUBLE_EQ(m.trajectory.end(), issued < 3 ? 2.0 : 5.0 + 2.0);
    EXPECT_EQ(m.trajectory.outside(), Extrapolation::refuse);
  }
}

TEST(Queue, Pmc600Fig510HaltsAndStartsAgainBeforeRest) {
  const QueuedMotion m = queue({.commands = {{MoveVelocity{-1}, dynamics(10, 10)},
                                             aborting(Halt{}, dynamics(0, 20, 5), 3),
                                             aborting(MoveVelocity{-1}, dynamics(10, 10), 4)}});
  EXPECT_DOUBLE_EQ(m.commands[1].reached, -5);
  EXPECT_DOUBLE_EQ(m.trajectory.end(), 4.5);
  EXPECT_EQ(m.end.velocity, -10);
}

// ---- junctions -----------------------------------------------------------------------------------

TEST(Queue, JunctionVelocityIsThatOfTheMode) {
  const double expected[2][4] = {{5, 5, 20, 20}, {5, 20, 5, 20}};
  for (int order = 0; order < 2; ++order)
    for (std::size_t i = 0; i < 4; ++i)
      for (const double jerk : {200.0, 0.0})
        for (const double way : {1.0, -1.0}) {
          const Dynamics first = dynamics(order == 0 ? 5 : 20, 40, 30, jerk);
          const Dynamics second = dynamics(order == 0 ? 20 : 5, 40, 30, jerk);
          const QueuedMotion m =
              queue({.commands = {{MoveAbsolute{100 * way}, first},
                                  {MoveRelative{100 * way}, second, blending[i]}}});
          EXPECT_EQ(m.commands[0].planned, way * expected[order][i]);
          EXPECT_EQ(m.commands[0].reached, way * expected[order][i]);
          const Motion joint = m.trajectory.at(m.commands[0].end);
          EXPECT_NEAR(joint.position, 100 * way, 1e-13);
          EXPECT_NEAR(joint.velocity, way * expected[order][i], 1e-13);
          if (jerk > 0) {
            EXPECT_NEAR(joint.acceleration, 0, 1e-13);
          }
        }
}

TEST(Queue, SpeedsUpJustBeforeTheEndToLeaveFaster) {
  const QueuedMotion m =
      queue({.commands = {{MoveAbsolute{20}, dynamics(5, 10)},
                          {MoveAbsolute{100}, dynamics(10, 10), BufferMode::blending_high}}});
  // 0.5 s to 5 over 1.25; (100 - 25) / 20 = 3.75 from 5 to 10, in 0.5 s; 15 between at 5.
  EXPECT_DOUBLE_EQ(m.commands[0].end, 0.5 + 3 + 0.5);
  EXPECT_DOUBLE_EQ(m.trajectory.at(3.4).velocity, 5);
  EXPECT_EQ(m.commands[0].reached, 10);
}

TEST(Queue, TooShortAMoveBeforeTheJunctionReachesWhatItCan) {
  const double jerk = 100;
  for (const bool limited : {false, true}) {
    const Dynamics d = dynamics(50, 1000, 1000, limited ? jerk : 0);
    const QueuedMotion m = queue(
        {.commands = {{MoveAbsolute{0.1}, d}, {MoveAbsolute{1000}, d, BufferMode::blending_low}}});
    // v^2 = 2 a h; without a plateau h = v sqrt(v/j).
    const double highest = limited ? std::cbrt(0.1 * 0.1 * jerk) : std::sqrt(2 * 1000 * 0.1);
    EXPECT_EQ(m.commands[0].planned, 50);
    EXPECT_NEAR(m.commands[0].reached, highest, 1e-13 * highest);
    EXPECT_NEAR(m.trajectory.at(m.commands[0].end).position, 0.1, 1e-15);
  }
}

TEST(Queue, TooShortAMoveAfterTheJunctionIsEnteredAsFastAsItCanStop) {
  const double jerk = 100;
  for (const bool limited : {false, true}) {
    const Dynamics d = dynamics(50, 1000, 1000, limited ? jerk : 0);
    const QueuedMotion m =
        queue({.commands = {{MoveAbsolute{-1000}, d},
                            {MoveRelative{-0.125}, d, BufferMode::blending_low}}});
    const double highest = limited ? std::cbrt(0.125 * 0.125 * jerk) : std::sqrt(2 * 1000 * 0.125);
    EXPECT_NEAR(m.commands[0].reached, -highest, 1e-13 * highest);
    EXPECT_EQ(m.end.position, -1000.125);
    EXPECT_GE(extrema(m.trajectory, 0).min.value, -1000.125);
  }
}

TEST(Queue, LooksAheadOverAllMoves) {
  // A trapezoid cut into a thousand moves is the same trapezoid.
  QueueSpec spec;
  for (int i = 0; i < 1000; ++i)
    spec.commands.push_back({MoveRelative{0.1}, dynamics(10, 4, 2), BufferMode::blending_previous});
  const QueuedMotion m = queue(spec);
  const double ramps = 10 / 4.0 + 10 / 2.0;
  EXPECT_NEAR(m.trajectory.end(), ramps + (100 - 10 * ramps / 2) / 10, 1e-9);
  for (int i = 500; i < 1000; i += 50) {
    const auto& c = m.commands[static_cast<std::size_t>(i)];
    const double left = 100 - c.target;
    EXPECT_NEAR(c.reached, std::min(10.0, std::sqrt(2 * 2 * left)), 1e-9);
  }
}

TEST(Queue, StopsWhereItTurnsRoundAndWhereNothingIsLeft) {
  const Dynamics d = dynamics(5, 10, 8, 100);
  const auto mode = BufferMode::blending_low;
  const QueuedMotion m = queue({.commands = {{MoveAbsolute{3}, d},
                                             {MoveAbsolute{3}, d, mode},
                                             {MoveAbsolute{6}, d, mode},
                                             {MoveAbsolute{1}, d, mode},
                                             {Dwell{0.3}, {}, mode},
                                             {MoveVelocity{}, d, mode}}});
  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_EQ(m.commands[i].planned, 0) << i;
    EXPECT_EQ(m.commands[i].reached, 0) << i;
  }
  EXPECT_EQ(m.commands[1].begin, m.commands[1].end);
  EXPECT_NEAR(m.commands[4].end - m.commands[4].begin, 0.3, 1e-15);
  EXPECT_EQ(m.end.velocity, 5);
}

TEST(Queue, BlendsIntoAVelocityAndIntoAHalt) {
  const Dynamics d = dynamics(5, 10, 8, 100);
  const QueuedMotion run =
      queue({.commands = {{MoveAbsolute{3}, d},
                          {MoveVelocity{}, dynamics(7, 10), BufferMode::blending_low},
                          {Dwell{2}}}});
  EXPECT_EQ(run.commands[0].reached, 5);
  EXPECT_EQ(run.end.velocity, 7);
  EXPECT_DOUBLE_EQ(run.end.position, run.commands[1].target + 14);
  const QueuedMotion halt =
      queue({.commands = {{MoveAbsolute{-3}, d},
                          {Halt{}, dynamics(0, 1, 10), BufferMode::blending_high}}});
  EXPECT_EQ(halt.commands[0].reached, -5);
  EXPECT_DOUBLE_EQ(halt.end.position, -3 - 25 / 20.0);
}

TEST(Queue, AfterAVelocityTheNextBeginsInVelocity) {
  const Dynamics d = dynamics(10, 10);
  const QueuedMotion m = queue({.commands = {{MoveVelocity{}, d}, {MoveRelative{15}, d}}});
  EXPECT_EQ(m.commands[0].state, CommandState::done);
  EXPECT_DOUBLE_EQ(m.commands[0].end, 1);
  EXPECT_DOUBLE_EQ(m.trajectory.end(), 1 + 1 + 1);
  EXPECT_DOUBLE_EQ(m.end.position, 20);
}

TEST(Queue, ARampThatAlmostFitsIsTheMove) {
  // The ends differ by 4e-8 of the velocity, so that the way is only met to 3e-9 of it: an axis that
  // went back to make up for the difference would take eight hours.
  const QueuedMotion m =
      queue({.start = {127.56610068505584, 11.795507928818573, 0},
             .commands = {{MoveAbsolute{127.5700001130122},
                           dynamics(73.78860961192571, 0.001596512311571596, 0.001556615423086209,
                                    2026.4363616036244)},
                          {MoveAbsolute{416.3952404020008}, dynamics(74, 2.2, 0, 1.2),
                           BufferMode::blending_high}}});
  EXPECT_NEAR(m.commands[0].end, 0.0039 / 11.7955, 1e-6);
  EXPECT_GT(m.commands[0].reached, 11.7955);
}

// ---- a batch that begins too fast ------------------------------------------------------------------

TEST(Queue, PassesFasterThanPlannedWhereTheNextMovesCanCope) {
  // From 10 over 1 with 10: sqrt(100 - 20) is the least at the junction, planned are 2.
  const QueuedMotion m =
      queue({.start = {0, 10, 0},
             .commands = {{MoveAbsolute{1}, dynamics(2, 10)},
                          {MoveAbsolute{50}, dynamics(2, 10), BufferMode::blending_low}}});
  EXPECT_NEAR(m.commands[0].reached, std::sqrt(80), 1e-14);
  EXPECT_EQ(m.commands[0].planned, 2);
  EXPECT_LE(extrema(m.trajectory, 0).max.value, 50);
  EXPECT_EQ(m.end, (MotionState{50, 0, 0}));
}

TEST(Queue, OverTheEndItComesBackAndHandsOverAtRest) {
  const QueuedMotion m =
      queue({.start = {0, 10, 0},
             .commands = {{MoveAbsolute{1}, dynamics(2, 10, 5)},
                          {MoveAbsolute{2}, dynamics(2, 10), BufferMode::blending_low}}});
  EXPECT_NEAR(extrema(m.trajectory, 0).max.value, 10, 1e-13);  // slows with the lower of the two
  EXPECT_EQ(m.commands[0].reached, 0);
  EXPECT_EQ(m.end, (MotionState{2, 0, 0}));
}

TEST(Queue, StopsWithItsDecelerationToTurnRound) {
  const Dynamics fast = dynamics(10, 2, 20, 200);
  const Trajectory running = point_to_point(0, 50, fast).curve();
  const Trajectory halted = with_velocity(running, 4, 0, fast);
  for (const double way : {1.0, -1.0}) {
    const QueuedMotion m = queue(
        {.commands = {{MoveAbsolute{50 * way}, fast}, aborting(MoveAbsolute{5 * way}, fast, 4)}});
    EXPECT_NEAR(way * extrema(m.trajectory, 0).peak().value, halted.at(halted.end()).position,
                1e-12 * 50);
    EXPECT_NEAR(m.trajectory.end(), with_target(running, 4, 5, fast).end(), 1e-12 * 10);
    EXPECT_EQ(m.end, (MotionState{5 * way, 0, 0}));
    // MoveVelocity, too: the stop, and 10 to speed up to with 2, which takes 10/2 + 2/200.
    const QueuedMotion back =
        queue({.commands = {{MoveAbsolute{50 * way}, fast},
                            aborting(MoveVelocity{way > 0 ? -1 : 1}, fast, 4)}});
    EXPECT_NEAR(back.trajectory.end(), halted.end() + 5.01, 1e-12 * 10);
  }
}

TEST(Queue, ContinuesFromWhereItStoppedToTurnRound) {
  // From -3 it stops at -9/2; from there the junction is reached as from rest.
  const QueuedMotion m =
      queue({.start = {0, -3, 0},
             .commands = {{MoveAbsolute{10}, dynamics(2, 10, 1)},
                          {MoveAbsolute{20}, dynamics(2, 10, 1), BufferMode::blending_low}}});
  EXPECT_NEAR(extrema(m.trajectory, 0).min.value, -4.5, 1e-14);
  EXPECT_EQ(m.commands[0].reached, 2);
  EXPECT_NEAR(m.commands[0].end, 3 + 2 / 10.0 + (14.5 - 0.2) / 2, 1e-13);
}

TEST(Queue, AStopThatEndsAtTheTargetIsTheMove) {
  // At 1 s from 40, where stopping takes the other 10: by rounding it may end behind the target.
  const Dynamics d = dynamics(10, 20, 5);
  for (const double offset : {0.0, 0.1, 12345.6, -1e6}) {
    const QueuedMotion m = queue({.start = {offset, 10, 0},
                                  .commands = {{MoveAbsolute{offset + 10.1}, d},
                                               aborting(MoveAbsolute{offset + 10.1}, d, 1)}});
    EXPECT_NEAR(m.trajectory.end(), 2.01, 1e-9) << offset;
    EXPECT_EQ(m.end.position, offset + 10.1);
  }
}

TEST(Queue, TakesNoStepOfAccelerationOverFromATrapezoid) {
  // At 1 s the trapezoid speeds up with 20; what takes over with jerk 1 could get rid of that only
  // beyond 200. It finds 20 u/s at 10.
  const Dynamics soft = dynamics(30, 20, 0, 1);
  const QueuedMotion m = queue({.commands = {{MoveAbsolute{1000}, dynamics(100, 20)},
                                             aborting(MoveAbsolute{2000}, soft, 1)}});
  const MoveResult oracle = move_to({10, 20, 0}, {2000, 0, 0}, within(30, 20, 1));
  EXPECT_LE(extrema(m.trajectory, 1).max.value, 30 * (1 + 1e-12));
  EXPECT_NEAR(m.trajectory.end(), 1 + oracle.profile.duration(), 1e-11);
}

TEST(Queue, TakesOneJerkGivenTwice) {
  Dynamics d = dynamics(100, 500, 0, 10000);
  const double once = queue({.commands = {{MoveAbsolute{100}, d}}}).trajectory.end();
  d.deceleration_jerk = 10000;
  EXPECT_EQ(queue({.commands = {{MoveAbsolute{100}, d}}}).trajectory.end(), once);
}

TEST(Queue, WhatNeverBeganIsAborted) {
  const Dynamics d = dynamics(10, 10, 10, 100);
  const QueuedMotion m = queue({.commands = {{MoveAbsolute{10}, d},
                                             {MoveAbsolute{20}, d, BufferMode::blending_low},
                                             {MoveAbsolute{30}, d},
                                             aborting(MoveAbsolute{0}, d, 1.8)}});
  EXPECT_EQ(m.commands[0].state, CommandState::done);
  EXPECT_EQ(m.commands[1].state, CommandState::aborted);
  EXPECT_DOUBLE_EQ(m.commands[1].begin, 1.55);
  EXPECT_DOUBLE_EQ(m.commands[1].end, 1.8);
  EXPECT_EQ(m.commands[2].state, CommandState::aborted);
  EXPECT_EQ(m.commands[2].begin, m.commands[2].end);
  EXPECT_EQ(m.commands[2].target, 30);
  EXPECT_EQ(m.commands[3].begin, m.commands[1].end);
  EXPECT_TRUE(check_continuity(m.trajectory, 2).ok());
  EXPECT_EQ(m.end, (MotionState{0, 0, 0}));
}

TEST(Queue, AnAbortAfterTheEndFindsTheAxisWaiting) {
  const Dynamics d = dynamics(10, 10);
  const QueuedMotion m =
      queue({.commands = {{MoveAbsolute{10}, d}, aborting(MoveAbsolute{0}, d, 5)}});
  EXPECT_EQ(m.commands[0].state, CommandState::done);
  EXPECT_DOUBLE_EQ(m.commands[0].end, 2);
  EXPECT_DOUBLE_EQ(m.commands[1].begin, 5);
  EXPECT_DOUBLE_EQ(m.trajectory.end(), 7);
  const QueuedMotion late = queue({.commands = {aborting(MoveAbsolute{10}, d, 3)}});
  EXPECT_DOUBLE_EQ(late.trajectory.end(), 5);
}

TEST(Queue, TheLastOfSeveralInOneInstantWins) {
  // PMC600 manual 1.2, Fig. 1.5.
  const Dynamics d = dynamics(1000, 1000);
  const QueuedMotion m = queue(
      {.commands = {aborting(MoveAbsolute{2234}, d, 0), aborting(MoveAbsolute{-5000}, d, 0)}});
  EXPECT_EQ(m.commands[0].state, CommandState::aborted);
  EXPECT_EQ(m.end.position, -5000);
}

TEST(Queue, HasNoJumpAtTheEdgesOfTheMagnitudes) {
  for (const double limit : {1e-30, 1.0, 1e30})
    for (const double way : {1e-30, 1.0, 1e30})
      for (const double jerk : {0.0, 1e-30, 1e30}) {
        SCOPED_TRACE(number(limit) + " " + number(way) + " " + number(jerk));
        const QueuedMotion m =
            queue({.commands = {{MoveAbsolute{way}, dynamics(limit, limit, 0, jerk)}}});
        EXPECT_TRUE(check_continuity(m.trajectory, 0).ok());
        EXPECT_EQ(m.trajectory.at(0).position, 0);
        EXPECT_DOUBLE_EQ(m.trajectory.at(m.trajectory.end()).position, way);
      }
}

TEST(Queue, RejectsAnInvalidQueue) {
  const Dynamics d = dynamics(1, 1);
  const auto refused = [](const QueueSpec& spec, const std::string& key) {
    try {
      queue(spec);
      ADD_FAILURE() << key;
    } catch (const InputError& e) {
      EXPECT_EQ(e.key(), key);
    }
  };
  refused({}, "commands");
  refused({.commands = {{MoveAbsolute{0}, d}}}, "commands");
  refused({.commands = {{MoveAbsolute{std::nan("")}, d}}}, "commands[1].position");
  refused({.commands = {{MoveAbsolute{1}, d}, {MoveAbsolute{2}, dynamics(0, 1)}}},
          "commands[2].velocity");
  refused({.commands = {{Halt{}, dynamics(0, 0)}}}, "commands[1].acceleration");
  refused({.commands = {{MoveAbsolute{1}, dynamics(1, 1, -1)}}}, "commands[1].deceleration");
  refused({.commands = {{MoveAbsolute{1}, dynamics(1, 1, 1, -1)}}}, "commands[1].jerk");
  refused({.commands = {{MoveAbsolute{1}, {1, 1, 1, 2, 3}}}}, "commands[1].deceleration_jerk");
  refused({.commands = {{MoveAbsolute{1}, dynamics(1e-300, 1e-300, 0, 1e-300)}}},
          "commands[1].velocity");
  refused({.commands = {{MoveAbsolute{1}, d}, {MoveAbsolute{2}, dynamics(1, 1, 1e31)}}},
          "commands[2].deceleration");
  refused({.commands = {{MoveAbsolute{1}, dynamics(1, 1, 1, 1e-31)}}}, "commands[1].jerk");
  refused({.commands = {{MoveAbsolute{-1e31}, d}}}, "commands[1].position");
  refused({.commands = {{Dwell{1e31}}}}, "commands[1].time");
  refused({.start = {0, 1e200, 0}, .commands = {{Halt{}, d}}}, "start.velocity");
  // Each value is permitted, but stopping from 1e30 with 1 leads to 5e59.
  refused({.start = {0, 1e30, 0}, .commands = {{Halt{}, d}, {MoveAbsolute{1}, d}}}, "commands[2]");
  refused({.commands = {{MoveVelocity{2}, d}}}, "commands[1].direction");
  refused({.commands = {{Dwell{-1}}}}, "commands[1].time");
  refused({.commands = {{MoveAbsolute{1}, d}, {MoveAbsolute{2}, d, BufferMode::aborting}}},
          "commands[2].issued");
  refused({.commands = {{MoveAbsolute{1}, d}, {MoveAbsolute{2}, d, BufferMode::buffered, 1.0}}},
          "commands[2].issued");
  refused({.commands = {aborting(MoveAbsolute{1}, d, 2), aborting(MoveAbsolute{2}, d, 1)}},
          "commands[2].issued");
  refused({.commands = {{MoveAbsolute{1}, d}, aborting(Dwell{1}, d, 1)}}, "commands[2].mode");
  refused({.start = {0, 0, 1}, .commands = {{Dwell{1}}}}, "start.acceleration");
  refused({.start = {0, 0, 1}, .commands = {aborting(MoveAbsolute{1}, d, 1)}},
          "start.acceleration");
}

}  // namespace
}  // namespace jounce::queue_test
