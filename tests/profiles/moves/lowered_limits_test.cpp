// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "jounce/profiles/curve/extrema.hpp"
#include "jounce/profiles/moves/dynamics.hpp"
#include "jounce/profiles/moves/move.hpp"
#include "jounce/profiles/moves/s_curve.hpp"
#include "jounce/profiles/sequences/synchronize.hpp"

#include "support/random.hpp"

// Limits that are lowered while the axis moves: the start of a move lies outside its bounds.

namespace jounce::lowered_limits_test {
namespace {

using test::Random;

MotionState state_at(const Profile& f, double t) {
  const Motion m = f.at(t);
  return {m.position, m.velocity, m.acceleration};
}

/// Distance by which a move from a positive velocity passes its target, and the greatest motion
/// back, u.
struct Excess {
  double passes = 0, returns = 0;
};
Excess excess(const Profile& f) {
  if (f.phases() == 0) return {};
  const Ranges range = extrema(f.curve());
  return {range[0].max.value - f.end().position, -range[1].min.value};
}

void expect_neither_past_nor_back(const MotionState& from, const MotionState& to, const Bounds& b) {
  const MoveResult move = move_to(from, to, b);
  ASSERT_TRUE(move) << explain(move.status);
  const auto [passes, returns] = excess(move.profile);
  const double length = std::abs(from.position) + std::abs(to.position);
  EXPECT_LE(passes, 1e-12 * length);
  EXPECT_LE(returns, 1e-9 * from.velocity);
}

TEST(LoweredLimits, TheVelocityFallsWithoutPassingTheTarget) {
  const Profile running =
      s_curve({.to = 2000, .velocity = 926, .acceleration = 6000, .jerk = 12000});
  const MotionState now = state_at(running, 2.151);
  const MoveResult move = move_to(now, {2000, 0, 0}, within(385, 6000, 12000));
  ASSERT_TRUE(move);
  EXPECT_NEAR(move.profile.duration(), 0.570802, 1e-6);  // the old plan takes 0.564 s
  expect_neither_past_nor_back(now, {2000, 0, 0}, within(385, 6000, 12000));
  const Trajectory changed = with_target(running.curve(), 2.151, 2000,
                                         {.velocity = 385, .acceleration = 6000, .jerk = 12000});
  EXPECT_NEAR(extrema(changed, 0).max.value, 2000, 1e-9);
}

TEST(LoweredLimits, AMoveBrakesThroughTheLimitWhereThatIsShortest) {
  const MotionState from{4.1112293655527585, -0.92594238293810049, 0};
  const Bounds b = within(.38489889353253448, 6.1588516380011082, 11.844082699850201);
  const MoveResult move = move_to(from, {3.8511833076146971, 0, 0}, b);
  EXPECT_NEAR(move.profile.duration(), 0.561234, 1e-6);
}

TEST(LoweredLimits, AVelocityComesDownMonotonically) {
  const MoveResult move = move_velocity({.velocity = 3}, 2, within(2, 10, 100));
  EXPECT_DOUBLE_EQ(move.profile.duration(), 0.2);  // dv = (j/4) T^2
  EXPECT_GE(extrema(move.profile.curve(), 1).min.value, 2 - 1e-12);
}

TEST(LoweredLimits, AStopFromOutsideWithTwoJerksIsOneChangeOfVelocity) {
  const Bounds b{-9.1567305871427269, 2.3489989409797523,  -14.432634074685417,
                 11.425331492333317,  -11.562076656869385, 0.10456589107734925};
  const MoveResult move = stop({0.62763139075587782, -17.940181618071954, 9.0689197682955349}, b);
  EXPECT_NEAR(move.profile.duration(), 2.356272, 1e-6);
  EXPECT_LT(extrema(move.profile.curve(), 1).max.value, 1e-9);
}

TEST(LoweredLimits, ABlockedIntervalEndsWhereTheDurationIsPossible) {
  const MotionState from{0.11218189968189167, 1.6666260139287381, 0};
  const MotionState to{4.7517837303768866, 0.80367053894485285, -0.44123967088281679};
  const Bounds b = within(1.0106817062284312, 6.3444950311666233, 0.66334880452317102);
  const Durations d = durations(from, to, b);
  EXPECT_NEAR(d.minimum, 4.000168, 1e-6);
  EXPECT_NEAR(d.at_least(5), 5.6199202, 1e-6);
  EXPECT_TRUE(move_to(from, to, b, 5.61993));
}

Bounds random_bounds(Random& r) {
  return {-r.uniform(0.5, 3), r.uniform(0.5, 3),  -r.uniform(1, 10),
          r.uniform(1, 10),   -r.uniform(2, 100), r.uniform(2, 100)};
}

/// A move under way, its limits, and what one of them is lowered to at some instant.
TEST(LoweredLimits, NeverPassWhatTheFastestStopDoesNot) {
  constexpr int cases = 20000;
  Random r(57);
  int braked = 0;
  for (int i = 0; i < cases && !::testing::Test::HasFailure(); ++i) {
    SCOPED_TRACE("seed 57, case " + std::to_string(i));
    const Bounds before = random_bounds(r);
    const MotionState target{r.uniform(0.05, 5), 0, 0};
    const Profile running = move_to({}, target, before).profile;
    const MotionState now = state_at(running, r.uniform(0, running.duration()));
    Bounds b = before;
    b.velocity_max *= r.uniform(0.01, 1);
    const double stops = stop(now, b).profile.end().position;
    if (now.velocity <= 1e-6 || stops > target.position - 1e-12) continue;
    ++braked;
    expect_neither_past_nor_back(now, target, b);
  }
  EXPECT_GT(braked, cases / 3);
}

TEST(LoweredLimits, BrakingContinuesWhereTheTargetNeedsIt) {
  constexpr int cases = 20000;
  Random r(58);
  int extended = 0;
  for (int i = 0; i < cases && !::testing::Test::HasFailure(); ++i) {
    SCOPED_TRACE("seed 58, case " + std::to_string(i));
    const Bounds before = random_bounds(r);
    const MotionState target{r.uniform(0.05, 5), 0, 0};
    const Profile running = move_to({}, target, before).profile;
    // the phase in which the plan under way holds its deceleration
    const auto [length, jerk] = running.phase(running.phases() - 2);
    if (jerk != 0) continue;
    const double last = running.phase(running.phases() - 1).duration;
    const MotionState now =
        state_at(running, running.duration() - last - length * r.uniform(0.1, 0.9));
    if (!(now.acceleration < -1e-3)) continue;
    Bounds b = before;
    b.acceleration_min *= r.uniform(0.05, 0.95);
    if (stop(now, b).profile.end().position <= target.position) continue;
    ++extended;
    expect_neither_past_nor_back(now, target, b);
    const MoveResult move = move_to(now, target, b);
    EXPECT_GE(extrema(move.profile.curve(), 2).min.value, now.acceleration * (1 + 1e-12));
    // The same again on the way, and longer without a reversal.
    const double t = move.profile.duration() / 2;
    const MoveResult again = move_to(state_at(move.profile, t), target, b);
    EXPECT_NEAR(again.profile.duration(), t, 1e-6 * t);
  }
  EXPECT_GT(extended, cases / 50);
}

TEST(LoweredLimits, TheRuleIsTheSameInEveryUnitOfTimeAndLength) {
  const MotionState from{0, 10, -8};
  for (const double to : {9.0, 6.9, 5.0, 100.0}) {
    const double T = move_to(from, {to, 0, 0}, within(4, 1, 50)).profile.duration();
    const MoveResult in_other_units =
        move_to({0, 10 * 1024 / 8, -8.0 * 1024 / 64}, {to * 1024, 0, 0},
                within(4.0 * 1024 / 8, 1024.0 / 64, 50.0 * 1024 / 512));
    EXPECT_EQ(in_other_units.profile.duration(), 8 * T) << to;
  }
}

TEST(LoweredLimits, AStraightLineKeepsTheBoundsOfAxesInsideThem) {
  const std::array<AxisMove, 3> axes{{{{0, .4, .8}, {}, within(1, 1, 1)},
                                      {{0, .15, .3}, {}, within(.2, 1, 1)},
                                      {{0, .2, .4}, {}, within(1, 1, 1)}}};
  std::array<Profile, 3> out;
  const Synchronized s = synchronize(axes, Sync::phase, out);
  EXPECT_EQ(s.status, MoveStatus::not_straight);
  EXPECT_EQ(s.axis, 1U);
}

TEST(LoweredLimits, NoStraightMotionBreaksTheBoundsOfAnAxisInside) {
  Random r(59);
  int straight = 0;
  for (int i = 0; i < 20000 && !::testing::Test::HasFailure(); ++i) {
    SCOPED_TRACE("seed 59, case " + std::to_string(i));
    std::vector<AxisMove> axes;
    const MotionState from{0, r.uniform(-.5, .5), r.uniform(-1, 1)};
    const double way = r.uniform(-3, 3);
    for (int k = 0; k < 3; ++k) {
      const double c = r.uniform(-1, 1);
      const Bounds b = within(r.uniform(.1, 1), r.uniform(.5, 2), r.uniform(.5, 4));
      axes.push_back({{0, c * from.velocity, c * from.acceleration}, {c * way, 0, 0}, b});
    }
    const auto inside = [](const AxisMove& m) {
      const auto& [p, v, a] = m.from;
      const Bounds& b = m.bounds;
      return std::abs(v) <= b.velocity_max && std::abs(a) <= b.acceleration_max &&
             std::abs(v + a * std::abs(a) / (2 * b.jerk_max)) <= b.velocity_max;
    };
    if (!std::all_of(axes.begin(), axes.end(), inside)) continue;
    std::vector<Profile> out(3);
    if (synchronize(axes, Sync::phase, out).status != MoveStatus::ok) continue;
    ++straight;
    for (std::size_t k = 0; k < 3; ++k) {
      const Ranges range = extrema(out[k].curve());
      const Bounds& b = axes[k].bounds;
      EXPECT_LE(std::abs(range[1].peak().value), b.velocity_max * (1 + 1e-11));
      EXPECT_LE(std::abs(range[2].peak().value), b.acceleration_max * (1 + 1e-11));
      EXPECT_LE(std::abs(range[3].peak().value), b.jerk_max * (1 + 1e-11));
    }
  }
  EXPECT_GT(straight, 1000);
}

}  // namespace
}  // namespace jounce::lowered_limits_test
