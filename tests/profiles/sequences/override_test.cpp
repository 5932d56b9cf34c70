// SPDX-License-Identifier: Apache-2.0
#include "jounce/profiles/sequences/override.hpp"

#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "jounce/profiles/curve/between.hpp"
#include "jounce/profiles/error.hpp"
#include "jounce/profiles/moves/move.hpp"
#include "jounce/profiles/moves/s_curve.hpp"

#include "support/invariants.hpp"
#include "support/random.hpp"

namespace jounce::override_test {
namespace {

const Limits limits{.velocity = 10, .acceleration = 20, .jerk = 100};

Trajectory plan() {  // 5.7 s: ramps of 0.7 s, 4.3 s at 10
  return s_curve({.to = 50, .velocity = 10, .acceleration = 20, .jerk = 100}).curve();
}

Overridden play(const OverrideSpec& spec) {
  const std::array axes{plan()};
  return overridden(axes, std::span(&limits, 1), spec);
}

/// Conditions that hold for every request.
void expect_played(const Overridden& played, std::span<const Trajectory> axes,
                   std::span<const Limits> all) {
  EXPECT_TRUE(check_continuity(with(played.clock, Extrapolation::refuse), 2).ok());
  EXPECT_GE(extrema(played.clock, 1).min.value, -1e-12) << "never backwards";
  for (std::size_t i = 0; i < axes.size(); ++i) {
    EXPECT_TRUE(check(played.axes[i], all[i]).ok()) << "axis " << i + 1;
    EXPECT_TRUE(check_continuity(played.axes[i], 2).ok());
    const Trajectory held = with(axes[i], Extrapolation::hold);
    for (int n = 0; n <= 200; ++n) {
      const double t = played.clock.start() + played.clock.length() * n / 200;
      EXPECT_NEAR(played.axes[i].at(t).position, held.at(played.clock.at(t).position).position,
                  1e-12 * 50)
          << "off the path";
    }
    if (played.arrived) {
      EXPECT_NEAR(played.axes[i].at(played.axes[i].end()).position,
                  axes[i].at(axes[i].end()).position, 1e-12 * 50);
    }
  }
}

void expect_played(const Overridden& played) {
  const std::array axes{plan()};
  expect_played(played, axes, std::span(&limits, 1));
}

TEST(Override, WithoutRequestsIsThePlanStretched) {
  EXPECT_NEAR(play({}).clock.end(), 5.7, 1e-14);
  const Overridden half = play({.factor = 0.5});
  EXPECT_NEAR(half.clock.end(), 11.4, 1e-13);
  EXPECT_NEAR(extrema(half.axes[0], 1).max.value, 5, 1e-14);
  expect_played(half);
}

TEST(Override, AHoldInTheCruiseIsTheFastestStop) {
  const Overridden held = play({.requests = {{2, 0}}});
  expect_played(held);
  EXPECT_FALSE(held.arrived);
  ASSERT_TRUE(held.ramps[0].granted);
  EXPECT_EQ(held.ramps[0].begin, 2);
  const MoveResult fastest = stop({0, 10, 0}, within(10, 20, 100));
  EXPECT_NEAR(held.ramps[0].end - 2, fastest.profile.duration(), 1e-12);
  EXPECT_NEAR(held.axes[0].at(held.clock.end()).position,
              plan().at(2).position + fastest.profile.end().position, 1e-12 * 50);
  EXPECT_EQ(held.axes[0].at(100).velocity, 0);
}

TEST(Override, ResumesExactlyOnThePath) {
  const Overridden played = play({.requests = {{2, 0}, {4, 1}}});
  expect_played(played);
  EXPECT_TRUE(played.arrived);
  EXPECT_EQ(played.axes[0].at(3.5).velocity, 0);
  // Stop and start cost a ramp each (0.7 s over 3.5 u, instead of 0.35 s) and the stand between.
  EXPECT_NEAR(played.clock.end(), 5.7 + 2 * 0.35 + (4 - 2.7), 1e-9);
}

TEST(Override, AHoldTakesAtMostThreeTimesTheFastestStop) {
  // Or the motion ends by itself, if that comes first. 3.13 was measured.
  for (const SCurveSpec& spec :
       {SCurveSpec{.to = 50, .velocity = 10, .acceleration = 20, .jerk = 100},
        SCurveSpec{.to = 1000, .velocity = 100, .acceleration = 500, .jerk = 10000},
        SCurveSpec{.to = 50, .velocity = 100, .acceleration = 1000, .jerk = 20000},
        SCurveSpec{.to = 5, .velocity = 10, .acceleration = 20, .jerk = 40}})
    for (const double room : {1.0, 1.2, 1.5, 2.0}) {
      const std::array axes{s_curve(spec).curve()};
      const double a = spec.acceleration * room;
      const double j = spec.jerk * room;
      const std::array all{Limits{.velocity = spec.velocity, .acceleration = a, .jerk = j}};
      for (int n = 1; n < 40; ++n) {
        const double t = axes[0].end() * n / 40;
        const Overridden held = overridden(axes, all, {.requests = {{t, 0}}});
        const double still = held.ramps[0].granted ? held.ramps[0].end : held.clock.end();
        const Jet now = axes[0].jet(t);
        const MoveResult fastest = stop({now[0], now[1], now[2]}, within(spec.velocity, a, j));
        EXPECT_LE(still - t, 3.2 * fastest.profile.duration()) << "at " << t << ", room " << room;
        EXPECT_GE(still - t, fastest.profile.duration() * (1 - 1e-9)) << "at " << t;
      }
    }
}

TEST(Override, AHoldWhileAcceleratingIsNoLaterThanOneInTheCruiseAfterIt) {
  for (const double t : {0.1, 0.3, 0.5, 0.69}) {
    SCOPED_TRACE(t);
    const Overridden held = play({.requests = {{t, 0}}});
    expect_played(held);
    // No path can be stopped on faster than the axis itself can stop.
    const Jet now = plan().jet(t);
    const MoveResult fastest = stop({now[0], now[1], now[2]}, within(10, 20, 100));
    EXPECT_GE(held.ramps[0].end - t, fastest.profile.duration() * (1 - 1e-12));
    EXPECT_LE(held.ramps[0].end, 0.7 + 0.7 + 1e-12);
  }
}

TEST(Override, BrakingAtTheLimitCannotBeHeld) {
  const Overridden late = play({.requests = {{5.3, 0}}});
  expect_played(late);
  if (!late.ramps[0].granted) {
    EXPECT_NEAR(late.clock.end(), 5.7, 1e-14);
  }
  // If the margin is ample, the hold works anywhere.
  const std::array axes{plan()};
  const std::array roomy{Limits{.velocity = 10, .acceleration = 40, .jerk = 800}};
  const Overridden held = overridden(axes, roomy, {{{5.3, 0}, {7, 1}}});
  expect_played(held, axes, roomy);
  EXPECT_TRUE(held.ramps[0].granted);
  EXPECT_LT(held.ramps[0].end, 5.7) << "it stands before the plan would have ended";
  EXPECT_EQ(held.axes[0].at(6.9).velocity, 0);
  EXPECT_TRUE(held.arrived);
}

TEST(Override, AHoldThatJustFitsIsGranted) {
  // Between two of the coarse steepnesses: the sharper one breaks a limit, the gentler one ends
  // after the motion.
  const std::array axes{s_curve({.to = 1, .velocity = 4, .acceleration = 10, .jerk = 5}).curve()};
  const std::array all{Limits{.velocity = 4, .acceleration = 10, .jerk = 9}};
  for (const double t : {0.70, 0.75, 0.80}) {
    const Overridden held = overridden(axes, all, {.requests = {{t, 0}}});
    expect_played(held, axes, all);
    EXPECT_TRUE(held.ramps[0].granted) << "at " << t;
    EXPECT_LT(held.ramps[0].end, axes[0].end()) << "at " << t;
    EXPECT_FALSE(held.arrived);
  }
  const std::array longer{plan()};
  const std::array roomy{Limits{.velocity = 12, .acceleration = 24, .jerk = 150}};
  const Overridden held = overridden(longer, roomy, {.requests = {{4.85, 0}}});
  expect_played(held, longer, roomy);
  EXPECT_TRUE(held.ramps[0].granted);
}

TEST(Override, AboveOneIsReducedToTheRoomThereIs) {
  const std::array axes{plan()};
  const std::array roomy{Limits{.velocity = 11, .acceleration = 100, .jerk = 1000}};
  const Overridden fast = overridden(axes, roomy, {.requests = {{1, 1.2}}, .maximum = 1.2});
  expect_played(fast, axes, roomy);
  EXPECT_NEAR(fast.ramps[0].factor, 1.1, 1e-14) << "velocity 10 under a limit of 11";
  const Overridden none = play({.requests = {{1, 1.2}}, .maximum = 1.2});
  EXPECT_NEAR(none.ramps[0].factor, 1, 1e-14);
  EXPECT_THROW(play({.requests = {{1, 1.2}}}), InputError) << "above the maximum";
}

TEST(Override, ARequestReplacesARampThatHasBegun) {
  const Overridden played = play({.requests = {{2, 0}, {2.2, 0.7}, {2.5, 0}, {2.6, 1}}});
  expect_played(played);
  EXPECT_TRUE(played.arrived);
}

TEST(Override, AllAxesKeepThePath) {
  const Trajectory x = plan();
  const Trajectory y = scaled(plan(), -0.5);
  const std::array axes{x, y};
  const std::array all{Limits{.velocity = 10, .acceleration = 25, .jerk = 200},
                       Limits{.velocity = 6, .acceleration = 10, .jerk = 50}};
  const Overridden played = overridden(axes, all, {{{1.5, 0.3}, {4, 0}, {6, 1}}});
  expect_played(played, axes, all);
  for (int n = 0; n <= 300; ++n) {
    const double t = played.clock.end() * n / 300;
    EXPECT_NEAR(played.axes[1].at(t).position, -0.5 * played.axes[0].at(t).position, 1e-12 * 50);
  }
}

TEST(Override, WhateverIsAskedTheLimitsHold) {
  test::Random random(9);
  for (int n = 0; n < 25 && !::testing::Test::HasFailure(); ++n) {
    OverrideSpec spec{.factor = random.below(3) == 0 ? random.uniform(0.2, 1) : 1};
    double t = 0;
    for (int i = random.below(5); i >= 0; --i) {
      t += random.log_uniform(0.02, 3);
      spec.requests.push_back({t, random.below(3) == 0 ? 0 : random.uniform(0, 1)});
    }
    spec.requests.push_back({t + 5, 1});
    const double v = random.log_uniform(1, 30);
    const double a = random.log_uniform(5, 100);
    const double j = random.log_uniform(20, 2000);
    const std::array axes{s_curve({.to = 50, .velocity = v, .acceleration = a, .jerk = j}).curve()};
    const double room = random.below(2) == 0 ? 1 : 1.5;
    const std::array all{Limits{.velocity = v, .acceleration = room * a, .jerk = room * j}};
    ::testing::Message text;
    text << "v " << v << " a " << a << " j " << j << " room " << room << " factor " << spec.factor;
    for (const auto& [time, factor] : spec.requests) text << "; " << time << ": " << factor;
    SCOPED_TRACE(text);
    const Overridden played = overridden(axes, all, spec);
    expect_played(played, axes, all);
    EXPECT_TRUE(played.arrived) << "the last request resumes";
  }
}

TEST(Override, DoesNotDependOnTheUnit) {
  const double big = 0x1p10;
  const std::array axes{scaled(plan(), big)};
  const std::array all{Limits{.velocity = 10 * big, .acceleration = 20 * big, .jerk = 100 * big}};
  const OverrideSpec spec{.requests = {{0.4, 0.2}, {2, 0}, {3, 1}}};
  EXPECT_EQ(overridden(axes, all, spec).clock.end(), play(spec).clock.end());
}

TEST(Override, ReportsTheLimitThatThePlanBreaks) {
  const std::array axes{trapezoid({.to = 10, .velocity = 10, .acceleration = 20}).curve()};
  const std::array tight{Limits{.velocity = 8, .acceleration = 20, .jerk = 100}};
  try {
    overridden(axes, tight, {});
    FAIL() << "velocity 10 under a limit of 8";
  } catch (const InputError& error) {
    EXPECT_STREQ(
        error.what(),
        "axis[1].limits.velocity = 8: is exceeded before any override: the plan itself has "
        "the velocity 10 at the time 0.5");
  }
}

TEST(Override, RejectsWhatItCannotPlay) {
  EXPECT_THROW(play({.factor = -0.1}), InputError);
  EXPECT_THROW(play({.factor = 0}), InputError) << "nothing sets it going";
  try {
    const std::array moving{between(plan(), 1, 5.7)};
    (void)overridden(moving, std::span(&limits, 1), {.factor = 0.5});
    FAIL() << "the velocity would step from 10 to 5";
  } catch (const InputError& error) {
    EXPECT_STREQ(
        error.what(),
        "factor = 0.5: must be 1, because axis[1] begins in motion, at velocity 10, and any "
        "other factor steps it");
  }
  EXPECT_THROW(play({.requests = {{2, 0}, {1, 1}}}), InputError);
  EXPECT_THROW(play({.requests = {{-1, 0}}}), InputError);
  const std::array axes{plan()};
  const std::array tight{Limits{.velocity = 9, .acceleration = 20, .jerk = 100}};
  EXPECT_THROW(overridden(axes, tight, {}), InputError);
  EXPECT_THROW(overridden(axes, {}, {}), InputError) << "an axis without limits";
  const std::array open{Limits{.velocity = 10, .acceleration = 20}};
  EXPECT_THROW(overridden(axes, open, {}), InputError);
  const std::array wide{Limits{.velocity = 1000, .acceleration = 1e5, .jerk = 1e6}};
  const std::array steep{Trajectory({quintic(1, 0, 0, 0, 1, 0, 0)})};
  EXPECT_THROW(overridden(steep, wide, {{{0.5, 0}}}), InputError) << "15 is no degree of a segment";
}

}  // namespace
}  // namespace jounce::override_test
