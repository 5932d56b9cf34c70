// SPDX-License-Identifier: Apache-2.0
#include "jounce/profiles/moves/move.hpp"

#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include <gtest/gtest.h>

#include "jounce/profiles/curve/extrema.hpp"
#include "jounce/profiles/limits/limits.hpp"
#include "jounce/profiles/moves/s_curve.hpp"

#include "support/invariants.hpp"
#include "support/random.hpp"

namespace jounce::move_test {
namespace {

// The random workloads, the independent checker and the independent search are in proof/.

/// Every move arrives, keeps the bounds, and is smooth.
void expect_sound(const MoveResult& move, const MotionState& to, const Bounds& b) {
  ASSERT_TRUE(move) << explain(move.status);
  const Trajectory f = move.profile.curve();
  const Motion end = move.profile.at(move.profile.duration());
  EXPECT_EQ(end.position, to.position);
  EXPECT_EQ(end.velocity, to.velocity);
  EXPECT_EQ(end.acceleration, to.acceleration);
  const Ranges r = extrema(f);
  EXPECT_GE(r[1].min.value, b.velocity_min * (1 + 1e-12));
  EXPECT_LE(r[1].max.value, b.velocity_max * (1 + 1e-12));
  EXPECT_GE(r[2].min.value, b.acceleration_min * (1 + 1e-12));
  EXPECT_LE(r[2].max.value, b.acceleration_max * (1 + 1e-12));
  // Held, it would step to rest at a moving end.
  test::expect_invariants(with(f, Extrapolation::refuse), move.profile.order() - 1);
}

TEST(Move, FromRestToRestIsTheSCurve) {
  test::Random random(31);
  for (int i = 0; i < 2000; ++i) {
    const double distance = random.log_uniform(1e-3, 1e3);
    const double v = random.log_uniform(1e-2, 1e2);
    const double a = random.log_uniform(1e-2, 1e2);
    const double j = random.log_uniform(1e-2, 1e2);
    const MoveResult move = move_to({0, 0, 0}, {distance, 0, 0}, within(v, a, j));
    ASSERT_TRUE(move);
    const double expected =
        s_curve({.to = distance, .velocity = v, .acceleration = a, .jerk = j}).duration();
    EXPECT_NEAR(move.profile.duration(), expected, 2e-14 * expected)
        << distance << ' ' << v << ' ' << a << ' ' << j;
  }
}

TEST(Move, WithoutJerkLimitIsTheTrapezoid) {
  Bounds b = within(50, 0.25);
  b.acceleration_min = -0.125;
  const MoveResult move = move_to({0, 0, 0}, {50000, 0, 0}, b);
  EXPECT_DOUBLE_EQ(move.profile.duration(), 1300);  // Googol 7.2
  EXPECT_EQ(move.profile.order(), 2);
}

TEST(Move, WithVelocityLimitedAloneIsALine) {
  const Bounds b{.velocity_min = -2, .velocity_max = 4};
  EXPECT_DOUBLE_EQ(move_to({1, 0, 0}, {9, 0, 0}, b).profile.duration(), 2);
  EXPECT_DOUBLE_EQ(move_to({9, 0, 0}, {1, 0, 0}, b).profile.duration(), 4);
  EXPECT_EQ(move_to({9, 0, 0}, {1, 0, 0}, b).profile.order(), 1);
}

TEST(Move, SolvesTheTieThatNeedsFourSeconds) {
  // The exact answer exists: acceleration 1 -> -1 -> 1 -> ... covers -3 in 4 s at no net velocity.
  const MotionState from{1, 0, 1};
  const MotionState to{-2, 0, 1};
  const MoveResult move = move_to(from, to, within(2, 2, 2));
  expect_sound(move, to, within(2, 2, 2));
  EXPECT_NEAR(move.profile.duration(), 4, 1e-14);
}

TEST(Move, IsTheSameInUnitsManyDecadesApart) {
  const double expected = std::cbrt(32);  // rest to rest under jerk alone
  for (const double unit : {1e-39, 1e-20, 1.0, 1e20, 1e39}) {
    const MoveResult move = move_to({}, {unit, 0, 0}, within(10 * unit, 10 * unit, unit));
    ASSERT_TRUE(move);
    EXPECT_NEAR(move.profile.duration(), expected, 1e-14 * expected) << unit;
    const Bounds b = within(2 * unit, 10 * unit, unit);
    const MoveResult moving = move_to({0, unit, -unit}, {unit, -unit, 0}, b);
    ASSERT_TRUE(moving);
    EXPECT_NEAR(moving.profile.duration(),
                move_to({0, 1, -1}, {1, -1, 0}, within(2, 10, 1)).profile.duration(), 1e-12)
        << unit;
  }
}

TEST(Move, WhatMayStepStepsToTheTarget) {
  const MoveResult first = move_to({}, {1, 0.5, 0}, within(2));
  ASSERT_TRUE(first);
  EXPECT_EQ(first.profile.end().velocity, 0.5);
  const MoveResult second = move_to({}, {1, 0, -1}, within(2, 2));
  ASSERT_TRUE(second);
  EXPECT_EQ(second.profile.end().acceleration, -1);
  EXPECT_EQ(move_velocity({0, 1, 0}, -1, within(2)).profile.end().velocity, -1);
}

TEST(Move, EachDirectionHasItsOwnBounds) {
  const Bounds b{.velocity_min = -1,
                 .velocity_max = 3,
                 .acceleration_min = -2,
                 .acceleration_max = 5,
                 .jerk_min = -20,
                 .jerk_max = 40};
  const MotionState a{-4, 0.5, -1};
  const MotionState c{4, -0.5, 1};
  expect_sound(move_to(a, c, b), c, b);
  expect_sound(move_to(c, a, b), a, b);
  // Rising with acceleration 5 (jerks 40 and 20: 5/40 + 5/20 s less a half each way) to 3 ...
  const MoveResult up = move_to({0, 0, 0}, {100, 0, 0}, b);
  const double rise = 3.0 / 5 + (5.0 / 40 + 5.0 / 20) / 2;
  const double fall = 3.0 / 2 + (2.0 / 20 + 2.0 / 40) / 2;
  EXPECT_DOUBLE_EQ(extrema(up.profile.curve(), 1).max.value, 3);
  double until_cruise = 0;
  for (std::size_t i = 0; i < 3; ++i) until_cruise += up.profile.phase(i).duration;
  EXPECT_NEAR(until_cruise, rise, 1e-14);
  double after_cruise = 0;
  for (std::size_t i = 4; i < 7; ++i) after_cruise += up.profile.phase(i).duration;
  EXPECT_NEAR(after_cruise, fall, 1e-14);
}

TEST(Move, ToWhereItIsTakesNoTime) {
  const MotionState s{3, 1, -2};
  const MoveResult move = move_to(s, s, within(5, 5, 5));
  ASSERT_TRUE(move);
  EXPECT_EQ(move.profile.duration(), 0);
  EXPECT_EQ(move.profile.at(0).velocity, 1);
}

TEST(Move, FromBeyondTheVelocityLimitComesInsideAndArrives) {
  const Bounds b = within(2, 5, 50);
  const MotionState to{30, 0, 0};
  for (const MotionState& from : {MotionState{0, 7, 0}, {0, -7, 3}, {0, 1.9, 30}, {0, 0, -30}}) {
    const MoveResult move = move_to(from, to, b);
    ASSERT_TRUE(move);
    const Trajectory f = move.profile.curve();
    test::expect_invariants(with(f, Extrapolation::refuse), 2);
    // Inside as fast as the bounds allow, and never out again.
    bool inside = false;
    for (int i = 0; i <= 10000; ++i) {
      const Motion m = f.at(f.end() * i / 10000);
      const bool now =
          std::abs(m.velocity) <= 2 * (1 + 1e-12) && std::abs(m.acceleration) <= 5 * (1 + 1e-12);
      if (inside) {
        ASSERT_TRUE(now) << "at " << f.end() * i / 10000 << ": " << m.velocity << ' '
                         << m.acceleration;
      }
      // A velocity that must still swing over the limit is not inside for good.
      inside = now && std::abs(m.velocity) + m.acceleration * m.acceleration / 100 <= 2;
    }
    EXPECT_TRUE(inside);
    EXPECT_EQ(f.at(f.end()).position, 30);
  }
}

TEST(Move, LastsExactlyAsLongAsAsked) {
  const Bounds b = within(1, 2, 10);
  const MotionState from{0, 0.3, 0.5};
  const MotionState to{1, 0, 0};
  const double least = durations(from, to, b).minimum;
  for (const double factor : {1.0, 1.001, 1.3, 2.0, 10.0, 1000.0}) {
    const MoveResult move = move_to(from, to, b, factor * least);
    expect_sound(move, to, b);
    EXPECT_NEAR(move.profile.duration(), factor * least, 1e-13 * factor * least);
  }
  EXPECT_EQ(move_to(from, to, b, 0.999 * least).status, MoveStatus::too_short);
  EXPECT_EQ(move_to(from, to, b, std::nan("")).status, MoveStatus::not_finite);
}

TEST(Move, FromBeyondTheAccelerationLimitLastsAsLongAsAsked) {
  // From Ruckig's benchmark distribution: the way inside and a mean of two motions after it, which
  // together have five different jerks.
  const MotionState from{1.891050840083218, 0, -1.2591629585278754};
  const MotionState to{-0.26578482380757729, 0.11989795430190574, 0.33841344201015777};
  const Bounds bounds = within(5.7297321649416419, 1.1338033686180311, 10.844420297214457);
  const MoveResult move = move_to(from, to, bounds, 65.5);
  ASSERT_TRUE(move);
  EXPECT_NEAR(move.profile.duration(), 65.5, 1e-12);
  EXPECT_TRUE(check_continuity(with(move.profile.curve(), Extrapolation::refuse), 2).ok());
}

TEST(Move, TheLeastDurationIsThatOfTheMotionWhereLittleIsLeft) {
  // Second order, a tenth of a nanounit short of the target, whose velocity differs in the last digits.
  const MotionState from{1.7727366580705761, 0.31692612728637021, 0};
  const MotionState to{1.7727366590305953, 0.31692612728635239, 0};
  const Bounds axis = within(5.3098754312292504, 4.6561211418742054);
  const double motion = move_to(from, to, axis).profile.duration();
  EXPECT_NEAR(durations(from, to, axis).minimum, motion, 1e-12 * motion);
  EXPECT_TRUE(move_to(from, to, axis, motion));
}

TEST(Move, NoDurationIsPossibleWhereThereIsNoMove) {
  const Durations none = durations({0, 0, 0}, {1, 5, 0}, within(2, 2, 20));
  ASSERT_EQ(none.status, MoveStatus::target_outside);
  for (const double t : {0.0, 1.0, 1e3}) EXPECT_FALSE(none.allows(t)) << t;
}

TEST(Move, AMovingTargetBlocksDurations) {
  // At the present velocity the move takes 0.1 s; a little longer is possible, but a stop is not:
  // then the axis is past the target and has to come back.
  const Bounds b = within(2, 2, 20);
  const MotionState from{0, 1, 0};
  const MotionState to{0.1, 1, 0};
  const Durations d = durations(from, to, b);
  ASSERT_EQ(d.status, MoveStatus::ok);
  ASSERT_EQ(d.count, 1U);
  EXPECT_LT(d.minimum, 0.1);
  const auto [begin, end] = d.blocked[0];
  EXPECT_GT(begin, 0.1);
  EXPECT_EQ(move_to(from, to, b, (begin + end) / 2).status, MoveStatus::blocked);
  EXPECT_EQ(d.at_least((begin + end) / 2), end);
  for (const double t : {begin, end, (d.minimum + begin) / 2, 2 * end}) {
    const MoveResult move = move_to(from, to, b, t);
    expect_sound(move, to, b);
    EXPECT_NEAR(move.profile.duration(), t, 1e-12 * t);
  }
}

TEST(Move, StopsAtAWallWithoutTouchingIt) {
  // The shortest motion to rest here overshoots and comes back; the wall forbids that.
  Bounds b = within(2, 2, 4);
  const MotionState from{0, 1.5, 0};
  const double straight = stop(from, b).profile.end().position;
  for (const double share : {0.999, 0.985}) {
    const MotionState to{share * straight, 0, 0};
    b.position_max = Bounds::none;
    const MoveResult free = move_to(from, to, b);
    EXPECT_GT(extrema(free.profile.curve(), 0).max.value, to.position);
    b.position_max = to.position;
    const MoveResult kept = move_to(from, to, b);
    ASSERT_TRUE(kept) << explain(kept.status);
    EXPECT_LE(extrema(kept.profile.curve(), 0).max.value, to.position * (1 + 1e-13));
    EXPECT_GT(kept.profile.duration(), free.profile.duration());
    expect_sound(kept, to, b);
  }
  // Even the hardest braking overshoots this one.
  const MotionState too_near{0.5 * straight, 0, 0};
  b.position_max = too_near.position;
  EXPECT_EQ(move_to(from, too_near, b).status, MoveStatus::position_limit);
}

TEST(Move, SetsOutFromBehindAWall) {
  // The same backwards in time: to leave the wall at speed, the run-up must not begin behind it.
  Bounds b = within(2, 2, 4);
  const MotionState to{0, -1.5, 0};
  const double run_up = stop({0, 1.5, 0}, b).profile.end().position;
  const MotionState from{0.99 * run_up, 0, 0};
  const MoveResult free = move_to(from, to, b);
  EXPECT_GT(extrema(free.profile.curve(), 0).max.value, from.position);
  b.position_max = from.position;
  const MoveResult kept = move_to(from, to, b);
  ASSERT_TRUE(kept) << explain(kept.status);
  EXPECT_LE(extrema(kept.profile.curve(), 0).max.value, from.position * (1 + 1e-13));
  expect_sound(kept, to, b);
}

TEST(MoveVelocity, TakesTheTimeOfItsRamp) {
  // dv/a + a/j
  const MoveResult move = move_velocity({2, 0, 0}, 10, within(20, 5, 50));
  ASSERT_TRUE(move);
  EXPECT_DOUBLE_EQ(move.profile.duration(), 2.1);
  EXPECT_DOUBLE_EQ(move.profile.end().position, 2 + 5 * 2.1);
  EXPECT_EQ(move.profile.end().velocity, 10);
}

TEST(MoveVelocity, StopsFromAnyState) {
  test::Random random(32);
  const Bounds b = within(3, 4, 30);
  for (int i = 0; i < 2000; ++i) {
    const MotionState from{random.uniform(-5, 5), random.uniform(-6, 6), random.uniform(-8, 8)};
    const MoveResult move = stop(from, b);
    ASSERT_TRUE(move);
    const Motion end = move.profile.at(move.profile.duration());
    EXPECT_EQ(end.velocity, 0);
    EXPECT_EQ(end.acceleration, 0);
    test::expect_invariants(with(move.profile.curve(), Extrapolation::refuse), 2);
    if (HasFailure()) {
      ADD_FAILURE() << from.velocity << ' ' << from.acceleration;
      break;
    }
  }
}

TEST(Move, ReportsErrors) {
  const Bounds b = within(1, 1, 1);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(move_to({nan, 0, 0}, {1, 0, 0}, b).status, MoveStatus::not_finite);
  EXPECT_EQ(move_to({0, 0, 0}, {1e200, 0, 0}, b).status, MoveStatus::not_finite);
  EXPECT_EQ(move_to({}, {1, 0, 0}, within(0, 1, 1)).status, MoveStatus::invalid_bounds);
  EXPECT_EQ(move_to({}, {1, 0, 0}, within(1, nan, 1)).status, MoveStatus::invalid_bounds);
  EXPECT_EQ(move_to({}, {1, 0, 0}, {}).status, MoveStatus::invalid_bounds);
  Bounds one_sided = b;
  one_sided.jerk_min = -Bounds::none;
  EXPECT_EQ(move_to({}, {1, 0, 0}, one_sided).status, MoveStatus::invalid_bounds);
  EXPECT_EQ(move_to({}, {1, 1.1, 0}, b).status, MoveStatus::target_outside);
  EXPECT_EQ(move_to({}, {1, 0, 1.1}, b).status, MoveStatus::target_outside);
  EXPECT_EQ(move_to({}, {1, 0.9, -1}, b).status, MoveStatus::target_unreachable);
  EXPECT_EQ(move_to({}, {1, 0, 0}, b, Bounds::none).status, MoveStatus::not_finite);
  for (const double extreme : {1e-300, 1e-60, 1e60, 1e300})
    EXPECT_EQ(move_to({}, {1, 0, 0}, within(extreme, extreme, extreme)).status,
              MoveStatus::invalid_bounds);
  EXPECT_EQ(move_to({}, {1, 5, 0}, within(2)).status, MoveStatus::target_outside);
  EXPECT_EQ(move_to({}, {1, 0, 3}, within(2, 2)).status, MoveStatus::target_outside);
  for (int s = 0; s <= static_cast<int>(MoveStatus::wrong_size); ++s)
    EXPECT_STRNE(explain(static_cast<MoveStatus>(s)), "");
}

TEST(Move, CruisesWithoutAccelerationWhateverTheRatioOfTheJerks) {
  test::Random random(8);
  for (int i = 0; i < 20000 && !::testing::Test::HasFailure(); ++i) {
    SCOPED_TRACE("seed 8, case " + std::to_string(i));
    const double jerk = random.log_uniform(0.1, 10);
    Bounds b = within(random.log_uniform(0.1, 10), random.log_uniform(0.1, 10), jerk);
    (i % 2 == 0 ? b.jerk_min : b.jerk_max) *= random.log_uniform(1e3, 1e6);
    const double most = 0.9 * b.velocity_max;
    const MotionState from{random.uniform(-5, 5), random.uniform(-most, most), 0};
    const MotionState to{random.uniform(-100, 100), random.uniform(-most, most), 0};
    const Profile f = move_to(from, to, b).profile;
    const double half = f.duration() / 2;
    const double far = std::abs(from.position) + std::abs(to.position) + b.velocity_max * half;
    EXPECT_NEAR(f.at(std::nextafter(half, 0)).position,
                f.at(std::nextafter(half, 2 * half)).position, 8e-15 * far);
    double t = 0;
    for (std::size_t k = 0; k < f.phases(); ++k) {
      const auto [length, value] = f.phase(k);
      const double a = std::abs(f.at(t + length / 2).acceleration);
      EXPECT_FALSE(value == 0 && a > 0 && a < 1e-12 * b.acceleration_max) << a;
      t += length;
    }
  }
}

TEST(Profile, TakesNoMoreRoomThanPromised) {
  EXPECT_LE(sizeof(Profile), 195U);
}

TEST(Move, WithoutAMoveTheProfileRestsAtTheStart) {
  Bounds wall = within(1, 10, 100);
  wall.position_max = 200;
  const MotionState start{100, 0.5, 0};
  const MotionState beside{199.999, 1, 0};
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::pair<MoveResult, MotionState> refused[] = {
      {move_to(start, {300}, wall), start},       {move_to(start, {300}, wall, 500), start},
      {move_to(start, {110}, wall, 0.1), start},  {move_to(start, {110}, within(0, 1, 1)), start},
      {move_to(start, {110, 2, 0}, wall), start}, {move_to(start, {nan}, wall), start},
      {move_velocity(beside, 0.5, wall), beside}, {stop(beside, wall), beside},
      {move_velocity(start, 2, wall), start}};
  for (const auto& [move, from] : refused) {
    SCOPED_TRACE(explain(move.status));
    EXPECT_FALSE(move);
    EXPECT_EQ(move.profile.phases(), 0U);
    for (const double t : {-1.0, 0.0, 1.0, 1e3}) {
      const Motion now = move.profile.at(t);
      EXPECT_EQ(now.position, from.position);
      EXPECT_EQ(now.velocity, 0);
      EXPECT_EQ(now.acceleration, 0);
    }
  }
}

TEST(Move, AValueIsAMoveOrAnError) {
  const Bounds b = within(10, 20);
  EXPECT_EQ(move_to({}, {.position = 50}, b).value().curve().end(),
            move_to({}, {.position = 50}, b).profile.duration());
  const MoveResult none = move_to({}, {1, 5, 0}, within(2));
  try {
    (void)none.value();
    FAIL();
  } catch (const InputError& error) {
    EXPECT_EQ(error.rule(), explain(MoveStatus::target_outside));
  }
}

TEST(Move, BeginsInTheStateOfAMotion) {
  const Profile f = move_to({}, {.position = 50}, within(10, 20, 100)).value();
  const Motion now = f.at(1.25);
  const MotionState state = state_of(now);
  EXPECT_EQ(state.position, now.position);
  EXPECT_EQ(state.velocity, now.velocity);
  EXPECT_EQ(state.acceleration, now.acceleration);
}

}  // namespace
}  // namespace jounce::move_test
