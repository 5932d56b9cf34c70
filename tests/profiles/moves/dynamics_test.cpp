// SPDX-License-Identifier: Apache-2.0
#include "jounce/profiles/moves/dynamics.hpp"

#include "jounce/profiles/detail/velocity_ramp.hpp"
#include "jounce/profiles/error.hpp"
#include "jounce/profiles/moves/move.hpp"
#include "jounce/profiles/moves/s_curve.hpp"
#include "jounce/profiles/sequences/splice.hpp"

#include "controllers/motion.hpp"
#include "support/errors.hpp"
#include "support/random.hpp"

namespace jounce::dynamics_test {
namespace {

using test::Random;

Dynamics random_dynamics(Random& random, bool symmetric, bool jerk) {
  Dynamics d{.velocity = random.log_uniform(0.1, 100),
             .acceleration = random.log_uniform(0.1, 100),
             .deceleration = random.log_uniform(0.1, 100)};
  if (symmetric) d.deceleration = d.acceleration;
  if (jerk) d.jerk = random.log_uniform(0.1, 1000);
  return d;
}

MotionState random_state(Random& random, const Dynamics& d) {
  return {random.uniform(-10, 10), random.uniform(-1.5, 1.5) * d.velocity,
          d.jerk > 0 ? random.uniform(-1.5, 1.5) * d.acceleration : 0};
}

// ---- velocity ramps ------------------------------------------------------------------------------

TEST(VelocityRamp, ArrivesFromAnyStateWithinItsLimits) {
  Random random(61);
  for (int i = 0; i < 4000 && !::testing::Test::HasFailure(); ++i) {
    const Dynamics d = random_dynamics(random, false, i % 2 == 0);
    const MotionState from = random_state(random, d);
    const double v = random.uniform(-1, 1) * d.velocity;
    SCOPED_TRACE(::testing::Message() << i << ": " << from << " to " << v << " under " << d);
    const Profile p = velocity_ramp(from, v, d);
    EXPECT_EQ(p.start(), from);
    EXPECT_EQ(p.end().velocity, v);
    test::expect_arrives(p, 1e-11);
    const double peak = std::max({d.acceleration, d.deceleration, std::abs(from.acceleration)});
    const Range a = extrema(p.curve(), 2);
    EXPECT_LE(std::abs(a.peak().value), peak * (1 + 1e-11));
    test::expect_invariants(with(p.curve(), Extrapolation::refuse), d.jerk > 0 ? 2 : 1);
  }
}

TEST(VelocityRamp, WithOneLimitIsAsFastAsTheSolver) {
  Random random(62);
  for (int i = 0; i < 4000 && !::testing::Test::HasFailure(); ++i) {
    const Dynamics d = random_dynamics(random, true, i % 2 == 0);
    const MotionState from = random_state(random, d);
    const double v = random.uniform(-1, 1) * d.velocity;
    SCOPED_TRACE(::testing::Message() << i << ": " << from << " to " << v << " under " << d);
    Bounds bounds = within(Bounds::none, d.acceleration);
    if (d.jerk > 0) bounds = within(Bounds::none, d.acceleration, d.jerk);
    const MoveResult move = move_velocity(from, v, bounds);
    ASSERT_TRUE(move);
    const Profile p = velocity_ramp(from, v, d);
    EXPECT_NEAR(p.duration(), move.profile.duration(), 1e-9 * p.duration());
    EXPECT_NEAR(p.end().position, move.profile.end().position,
                1e-9 * (1 + std::abs(p.end().position)));
  }
}

TEST(VelocityRamp, SlowsDownWithTheDecelerationAndSpeedsUpWithTheAcceleration) {
  const Dynamics d{.acceleration = 10, .deceleration = 20};
  EXPECT_DOUBLE_EQ(velocity_ramp({0, 40, 0}, -40, d).duration(), 2 + 4);
  EXPECT_DOUBLE_EQ(velocity_ramp({0, -40, 0}, -10, d).duration(), 1.5);
  EXPECT_DOUBLE_EQ(velocity_ramp({0, -10, 0}, -40, d).duration(), 3);
  EXPECT_EQ(velocity_ramp({0, 40, 0}, 40, d).phases(), 0U);
}

TEST(VelocityRamp, RandomRampsUseEachAccelerationInItsSense) {
  Random random(63);
  for (int i = 0; i < 500 && !::testing::Test::HasFailure(); ++i) {
    const Dynamics d = random_dynamics(random, false, i % 2 == 0);
    const MotionState from{0, random.uniform(-1, 1) * d.velocity, 0};
    const double v = random.uniform(-1, 1) * d.velocity;
    SCOPED_TRACE(::testing::Message() << i << ": " << from << " to " << v << " under " << d);
    test::expect_speeding_and_slowing(velocity_ramp(from, v, d).curve(), d.acceleration,
                                      d.deceleration);
  }
}

/// Checks each direction also if speeding up and slowing down have different jerks: at both ends
/// and in the middle of each phase, except at rest.
void expect_each_sense(const Profile& p, const Dynamics& d) {
  const Trajectory f = p.curve();
  const double standstill = 1e-7 * std::abs(extrema(f, 1).peak().value);
  const double none = 1e-7 * std::max(d.acceleration, d.deceleration);
  for (const Segment& phase : f.segments())
    for (int n = 0; n <= 32; ++n) {
      const Jet x = evaluate(phase, n / 32.0);
      if (std::abs(x[1]) <= standstill || std::abs(x[2]) <= none) continue;
      const bool up = x[1] * x[2] > 0;
      EXPECT_LE(std::abs(x[2]), (up ? d.acceleration : d.deceleration) * (1 + 1e-9));
      EXPECT_LE(std::abs(x[3]), (up ? d.jerk : d.deceleration_jerk) * (1 + 1e-9));
    }
}

TEST(VelocityRamp, AnAccelerationInForceFallsUnderTheLimitsOfItsOwnSense) {
  // -5 at 100 leads to 9.875, from where 0.025 is made up for at 400.
  const Dynamics a{.acceleration = 40, .deceleration = 5, .jerk = 400, .deceleration_jerk = 100};
  const Profile p = velocity_ramp({0, 10, -5}, 9.9, a);
  EXPECT_NEAR(p.duration(), 0.05 + 2 * std::sqrt(0.025 / 400), 1e-12);
  expect_each_sense(p, a);
  // +20 at 100 leads to 7, then back to 6 at 1000.
  const Dynamics b{.acceleration = 20, .deceleration = 20, .jerk = 100, .deceleration_jerk = 1000};
  const Profile q = velocity_ramp({0, 5, 20}, 6, b);
  EXPECT_NEAR(q.duration(), 0.2 + (1.0 / 20 + 20.0 / 1000), 1e-12);
  expect_each_sense(q, b);
  // +20 at 100 from -1: at rest with sqrt(200), then upwards at 1000 to 200/2000, and on to 5.
  const Dynamics c{.acceleration = 20, .deceleration = 20, .jerk = 1000, .deceleration_jerk = 100};
  const Profile r = velocity_ramp({0, -1, 20}, 5, c);
  EXPECT_DOUBLE_EQ(r.phase(0).duration, 2 / (20 + std::sqrt(200.0)));
  expect_each_sense(r, c);
}

TEST(VelocityRamp, RandomStatesWithinTheLimitsStayThere) {
  Random random(67);
  for (int i = 0; i < 20000 && !::testing::Test::HasFailure(); ++i) {
    Dynamics d = random_dynamics(random, i % 3 == 0, true);
    d.deceleration_jerk = random.log_uniform(0.1, 1000);
    MotionState from{0, random.uniform(-1, 1) * d.velocity, 0};
    const double sense = random.uniform(-1, 1) < 0 ? -1 : 1;
    from.acceleration = random.uniform(0, 1) * sense * std::copysign(1, from.velocity) *
                        (sense > 0 ? d.acceleration : d.deceleration);
    // Except the rest of an acceleration that reverses the axis.
    if (sense < 0 && d.deceleration > d.acceleration &&
        from.acceleration * from.acceleration > 2 * d.deceleration_jerk * std::abs(from.velocity))
      continue;
    const double v = random.uniform(-1, 1) * d.velocity;
    SCOPED_TRACE(::testing::Message()
                 << i << ": " << from << " to " << number(v) << " under " << d);
    const Profile p = velocity_ramp(from, v, d);
    test::expect_arrives(p, 1e-11);
    expect_each_sense(p, d);
  }
}

TEST(VelocityRamp, RejectsJerksThatAProfileCannotHold) {
  EXPECT_THROW(profiles_detail::velocity_ramp({}, 1, {1, 1, 2}, {1, 1, 3}), InputError);
  EXPECT_THROW(profiles_detail::velocity_ramp({}, 1, {1, 1, 0}, {1, 1, 1}), InputError);
  EXPECT_THROW(profiles_detail::velocity_ramp({}, 1, {1, 0, 0}, {1, 1, 1}), InputError);
  EXPECT_THROW(profiles_detail::velocity_ramp({}, 1, {0, 0, 0}, {1, 0, 0}), InputError);
  EXPECT_NO_THROW(profiles_detail::velocity_ramp({}, 1, {1, 1, 2}, {2, 1, 2}));
  EXPECT_NO_THROW(profiles_detail::velocity_ramp({}, 1, {1, 1, 1}, {2, 3, 3}));
}

TEST(VelocityRamp, NamesTheJerkThatItRejects) {
  using profiles_detail::RampLimits;
  const auto key = [](const RampLimits& up, const RampLimits& down) -> std::string {
    return test::key_of([&] { profiles_detail::velocity_ramp({}, 1, up, down); });
  };
  EXPECT_EQ(key({1, 1, 0}, {1, 1, 1}), "up.jerk_end");
  EXPECT_EQ(key({1, 1, 1}, {1, 0, 1}), "down.jerk_begin");
  EXPECT_EQ(key({1, 1, 1}, {0, 1, 1}), "down.acceleration");
  EXPECT_EQ(key({1, 1, 2}, {1, 1, 3}), "down.jerk_end");
}

TEST(VelocityRamp, RejectsStatesThatAreNoNumbersOrTooLarge) {
  const Dynamics step{.acceleration = 1};
  const Dynamics soft{.acceleration = 1, .jerk = 1};
  for (const double bad : {std::nan(""), Bounds::none, -Bounds::none})
    for (const Dynamics& d : {step, soft}) {
      EXPECT_THROW(velocity_ramp({bad, 0, 0}, 1, d), InputError);
      EXPECT_THROW(velocity_ramp({0, bad, 0}, 1, d), InputError);
      EXPECT_THROW(velocity_ramp({0, 0, bad}, 1, d), InputError);
      EXPECT_THROW(velocity_ramp({0, 0, 0}, bad, d), InputError);
    }
  for (const Dynamics& d : {step, soft}) {
    EXPECT_THROW(velocity_ramp({0, 1e200, 0}, 1, d), InputError);
    EXPECT_THROW(velocity_ramp({}, -1e200, d), InputError);
  }
  EXPECT_THROW(velocity_ramp({0, 0, 1e200}, 1, soft), InputError);
}

// ---- in flight -----------------------------------------------------------------------------------

TEST(InFlight, ANewTargetAndVelocityEndWhereTheManualsExampleDoes) {
  // PMC600 5.2.4, Fig. 5.16: at 2 s the axis is at 19500; at rest in 100000 after 6.0875 s.
  const Trajectory f =
      point_to_point(0, 50000, {.velocity = 10000, .acceleration = 100000}).curve();
  EXPECT_DOUBLE_EQ(f.at(2).position, 19500);
  const Trajectory g = with_target(f, 2, 100000, {.velocity = 20000, .acceleration = 200000});
  EXPECT_NEAR(g.end(), 6.0875, 1e-12);
  EXPECT_EQ(g.at(g.end()).position, 100000);
  test::expect_invariants(g, 1);
}

TEST(InFlight, AVelocityMoveReverses) {
  // PMC600 5.2.4, Fig. 5.17: 10000 at 100000, at 2 s -20000.
  const Dynamics d{.acceleration = 100000};
  const Trajectory f = with_velocity(velocity_ramp({}, 10000, d).curve(), 2, -20000, d);
  EXPECT_DOUBLE_EQ(f.end(), 2.3);
  EXPECT_NEAR(state_at(f, 2.3).velocity, -20000, 1e-10);
}

TEST(InFlight, ASecondMoveDuringTheFirstNeverStopsBetween) {
  // PMC600 5.2.2, Fig. 5.6 and 5.7; velocities are ours.
  const Dynamics d{.velocity = 2000, .acceleration = 4000, .jerk = 40000};
  const Trajectory first = point_to_point(0, 6000, d).curve();
  const Trajectory absolute = with_target(first, 2, 10000, d);
  EXPECT_EQ(absolute.at(absolute.end()).position, 10000);
  EXPECT_GT(absolute.at(3.5).velocity, 1999);  // place where the first would have stopped
  const double t = 1.9;
  const double base = first.at(t).position;
  const Trajectory relative = with_target(first, t, base + 4000, d);
  EXPECT_NEAR(relative.at(relative.end()).position, base + 4000, 1e-9);
}

TEST(InFlight, AHaltedMoveCanBeResumedBeforeItStops) {
  // PMC600 5.2.2, Fig. 5.10.
  const Dynamics d{.velocity = 3000, .acceleration = 6000, .jerk = 60000};
  const Trajectory f = point_to_point(0, 9000, d).curve();
  const Trajectory halted = with_velocity(f, 1, 0, d);
  const Trajectory resumed = with_target(halted, 1.2, 9000, d);
  EXPECT_EQ(resumed.at(resumed.end()).position, 9000);
  EXPECT_GT(resumed.end(), f.end());
  test::expect_invariants(resumed, 2);
  EXPECT_GT(extrema(resumed, 1).min.value, -1e-9);
}

TEST(InFlight, TheSameMoveAgainTakesNoLonger) {
  Random random(64);
  for (int i = 0; i < 2000 && !::testing::Test::HasFailure(); ++i) {
    const Dynamics d = random_dynamics(random, true, i % 2 == 0);
    const double to = random.uniform(-1, 1) * random.log_uniform(0.01, 1000);
    const Trajectory f = point_to_point(0, to, d).curve();
    const double t = random.uniform(0, f.end());
    SCOPED_TRACE(::testing::Message()
                 << i << ": to " << number(to) << " under " << d << " at " << number(t));
    const Trajectory again = with_target(f, t, to, d);
    EXPECT_NEAR(again.end(), f.end(), 1e-8 * f.end());
    EXPECT_DOUBLE_EQ(again.at(again.end()).position, to);
  }
}

TEST(InFlight, AnyChangeArrivesContinuouslyWithinTheLimits) {
  Random random(65);
  for (int i = 0; i < 3000 && !::testing::Test::HasFailure(); ++i) {
    const Dynamics d = random_dynamics(random, i % 3 == 0, i % 2 == 0);
    const double to = random.uniform(-1, 1) * random.log_uniform(0.1, 100);
    const Trajectory f = point_to_point(0, to, d).curve();
    const double t = random.uniform(0, 1.2) * f.end();
    Dynamics changed = random_dynamics(random, i % 3 == 0, i % 2 == 0);
    const double target = random.uniform(-1, 1) * random.log_uniform(0.1, 100);
    SCOPED_TRACE(::testing::Message()
                 << i << ": to " << number(to) << " under " << d << " at " << number(t) << " to "
                 << number(target) << " under " << changed);
    const Trajectory g = with_target(f, t, target, changed);
    EXPECT_NEAR(g.at(g.end()).position, target, 1e-15 * std::abs(extrema(g, 0).peak().value));
    EXPECT_EQ(g.outside(), Extrapolation::hold);
    EXPECT_EQ(with_velocity(f, t, 0, changed).outside(), Extrapolation::hold);
    // An acceleration in force goes on to change the velocity while the new jerk brings it down.
    const MotionState now = state_at(f, t);
    const double a = now.acceleration;
    const double carried = changed.jerk > 0 ? a * a / (2 * changed.jerk) : 0;
    double jerk = std::max(d.jerk, changed.jerk);
    if (d.jerk == 0) jerk = Bounds::none;
    test::expect_within(
        g, std::max({d.velocity, changed.velocity, std::abs(now.velocity) + carried}),
        std::max({d.acceleration, d.deceleration, changed.acceleration, changed.deceleration}),
        jerk);
    EXPECT_TRUE(check_continuity(g, d.jerk > 0 ? 2 : 1).ok());
  }
}

TEST(InFlight, TwoJerksDoNotLeadPastTheVelocity) {
  Random random(66);
  for (int i = 0; i < 1000 && !::testing::Test::HasFailure(); ++i) {
    Dynamics d = random_dynamics(random, false, true);
    d.deceleration_jerk = random.log_uniform(0.1, 1000);
    const double to = random.uniform(-1, 1) * random.log_uniform(0.1, 1000);
    const Trajectory f = point_to_point(0, to, d).curve();
    const double t = random.uniform(0, 1) * f.end();
    SCOPED_TRACE(::testing::Message()
                 << i << ": to " << number(to) << " under " << d << " at " << number(t));
    const Trajectory g = with_target(f, t, 2 * to, d);
    EXPECT_NEAR(g.at(g.end()).position, 2 * to, 1e-15 * std::abs(2 * to));
    test::expect_within(g, d.velocity, std::max(d.acceleration, d.deceleration),
                        std::max(d.jerk, d.deceleration_jerk));
  }
}

TEST(InFlight, WithTwoJerksTheSameMoveAgainChangesNothing) {
  Random random(68);
  for (int i = 0; i < 4000 && !::testing::Test::HasFailure(); ++i) {
    Dynamics d = random_dynamics(random, i % 2 == 0, true);
    d.deceleration_jerk = random.log_uniform(0.1, 1000);
    const double from = random.uniform(-100, 100);
    const double to = from + random.uniform(-1, 1) * random.log_uniform(0.1, 1000);
    const Trajectory f = point_to_point(from, to, d).curve();
    const double t = random.uniform(0, 1) * f.end();
    SCOPED_TRACE(::testing::Message() << i << ": from " << number(from) << " to " << number(to)
                                      << " under " << d << " at " << number(t));
    const Trajectory again = with_target(f, t, to, d);
    EXPECT_NEAR(again.end(), f.end(), 1e-6 * f.end());
    EXPECT_DOUBLE_EQ(again.at(again.end()).position, to);
    for (int n = 0; n <= 16; ++n) {
      const double x = t + (std::min(f.end(), again.end()) - t) * n / 16;
      EXPECT_NEAR(again.at(x).position, f.at(x).position, 1e-9 * (std::abs(from) + std::abs(to)));
    }
    EXPECT_TRUE(check_continuity(again, 2).ok());
  }
}

TEST(InFlight, WithTwoJerksAFartherTargetTakesAsLongAsIfItHadBeenGivenAtOnce) {
  Random random(69);
  for (int i = 0; i < 2000 && !::testing::Test::HasFailure(); ++i) {
    Dynamics d = random_dynamics(random, false, true);
    d.deceleration_jerk = random.log_uniform(0.1, 1000);
    const double to = random.log_uniform(0.1, 1000);
    const Trajectory f = point_to_point(0, to, d).curve();
    const Trajectory longer = point_to_point(0, 2 * to, d).curve();
    const double t = random.uniform(0, 1) * f.breaks()[1];  // both rise at the same jerk
    SCOPED_TRACE(::testing::Message()
                 << i << ": to " << number(to) << " under " << d << " at " << number(t));
    EXPECT_NEAR(with_target(f, t, 2 * to, d).end(), longer.end(), 1e-7 * longer.end());
    EXPECT_NEAR(with_target(longer, t, to, d).end(), f.end(), 1e-7 * f.end());
  }
}

TEST(InFlight, WhatEndsAtRestHoldsAndWhatEndsMovingRejects) {
  const Dynamics d{.velocity = 10, .acceleration = 20, .jerk = 100};
  const Trajectory move = point_to_point(0, 50, d).curve();
  for (const Extrapolation outside :
       {Extrapolation::refuse, Extrapolation::hold, Extrapolation::wrap}) {
    const Trajectory f = with(move, outside);
    for (const double t : {0.0, 0.3, 2.0, 9.0}) {
      EXPECT_EQ(with_target(f, t, 80, d).outside(), Extrapolation::hold);
      EXPECT_EQ(with_velocity(f, t, 5, d).outside(), Extrapolation::refuse);
    }
    EXPECT_EQ(with_velocity(f, 2, 0, d).outside(), Extrapolation::hold);
  }
  const Trajectory jog = with(velocity_ramp({}, 10, d).curve(), Extrapolation::refuse);
  const Trajectory placed = with_target(jog, 3, 80, d);
  EXPECT_DOUBLE_EQ(placed.at(placed.end() + 5).position, 80);
}

TEST(InFlight, UnequalRampsStopBeforeTheyTurnRound) {
  const Dynamics d{.velocity = 10, .acceleration = 10, .deceleration = 20};
  const Trajectory f = point_to_point(0, 100, d).curve();
  const Trajectory g = with_target(f, 2, 0, d);  // at 15; stops in 2.5, returns over 17.5
  EXPECT_DOUBLE_EQ(g.end(), 2 + 0.5 + (17.5 / 10 + 0.5 + 0.25));
  test::expect_speeding_and_slowing(g, 10, 20);
}

TEST(InFlight, ATargetJustWithinReachIsMetWithoutTurningRound) {
  const Dynamics d{.velocity = 10, .acceleration = 10, .deceleration = 20};
  const Trajectory f = point_to_point(0, 100, d).curve();
  for (const double target : {17.5, std::nextafter(17.5, 0), std::nextafter(17.5, 99)}) {
    const Trajectory g = with_target(f, 2, target, d);
    EXPECT_NEAR(g.end(), 2.5, 1e-6);
    EXPECT_DOUBLE_EQ(g.at(g.end()).position, target);
  }
}

TEST(InFlight, AJerkLimitedCommandTakesOverNoAccelerationThatSteps) {
  const Dynamics soft{.velocity = 10, .acceleration = 20, .jerk = 10};
  const Trajectory f = point_to_point(0, 50, {.velocity = 10, .acceleration = 20}).curve();
  // 6 u/s after 0.3 s; s-curves to rest and back up to speed, each of its own.
  const Trajectory halted = with_velocity(f, 0.3, 0, soft);
  EXPECT_DOUBLE_EQ(halted.end(), 0.3 + 2 * std::sqrt(6.0 / 10));
  test::expect_within(halted, 6, 20);
  const Trajectory late = with_velocity(f, 5.2, 0, soft);  // slowing down, at 6 u/s again
  EXPECT_NEAR(late.end(), 5.2 + 2 * std::sqrt(6.0 / 10), 1e-12);
  EXPECT_GT(extrema(late, 1).min.value, -1e-12);
  test::expect_within(with_target(f, 0.3, 50, soft), 10, 20);
  test::expect_invariants(halted, 1);
}

TEST(InFlight, RejectsAnInvalidNumber) {
  const Trajectory f = point_to_point(0, 100, {.velocity = 10, .acceleration = 10}).curve();
  EXPECT_THROW(with_target(f, 2, std::nan(""), {.velocity = 10, .acceleration = 10}), InputError);
  EXPECT_THROW(with_target(f, -1, 0, {.velocity = 10, .acceleration = 10}), InputError);
  EXPECT_THROW(with_target(f, 2, 0, {.velocity = 0, .acceleration = 10}), InputError);
  EXPECT_THROW(with_velocity(f, 2, 0, {.velocity = 1, .acceleration = 0}), InputError);
}

}  // namespace
}  // namespace jounce::dynamics_test
