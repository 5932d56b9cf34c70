// SPDX-License-Identifier: Apache-2.0
#include "jounce/gear/gear_in.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "jounce/cam/coupling/coupling_cycle.hpp"
#include "jounce/profiles/curve/extrema.hpp"
#include "jounce/profiles/error.hpp"
#include "jounce/profiles/limits/limits.hpp"
#include "jounce/profiles/moves/s_curve.hpp"

#include "support/errors.hpp"
#include "support/random.hpp"

namespace jounce::gear_in_test {
namespace {

TEST(GearIn, OfExample61FollowsInStep) {
  // PMC600 manual 6.1, example 6.1: master +-20000, v 10000, a 10000; gears -2 and 0.5.
  const Trajectory master =
      trapezoid({.to = 20000, .velocity = 10000, .acceleration = 10000}).curve();
  const Trajectory back =
      trapezoid({.from = 20000, .to = 0, .velocity = 10000, .acceleration = 10000}).curve();
  const Trajectory stroke = concatenated(master, back);
  for (const auto& [numerator, denominator, acceleration, end] :
       {std::tuple{-2, 1, 20000.0, -40000.0}, {1, 2, 5000.0, 10000.0}}) {
    const GearInSpec spec{
        .numerator = numerator, .denominator = denominator, .acceleration = 100000};
    EXPECT_TRUE(in_gear(gear_in(spec, {}, master.jet(0), 0), 0)) << "from standstill, at once";
    const Trajectory slave = gear_in(spec, 0, stroke, 0);
    EXPECT_DOUBLE_EQ(extrema(slave, 2).peak().value < 0 ? -extrema(slave, 2).peak().value
                                                        : extrema(slave, 2).peak().value,
                     acceleration);
    EXPECT_DOUBLE_EQ(slave.at(master.end()).position, end);
    EXPECT_NEAR(slave.at(stroke.end()).position, 0, 1e-9);
    EXPECT_EQ(slave.end(), stroke.end());
    EXPECT_EQ(slave.at(1.5).velocity, numerator * 10000.0 / denominator);
  }
}

TEST(GearIn, NeverMakesUpWhatItLostWhileRamping) {
  const Jet master{700, 100, 0, 0};
  const GearedIn gear =
      gear_in({.numerator = 3, .denominator = 2, .acceleration = 300}, {.position = 40}, master, 2);
  // 150 u/s in 0.5 s: 37.5 u of the master's 75.
  const auto at = [&](double t) { return point(gear, {700 + 100 * (t - 2), 100, 0, 0}, t); };
  EXPECT_FALSE(in_gear(gear, 2.4999));
  EXPECT_TRUE(in_gear(gear, 2.5));
  EXPECT_NEAR(at(2.25)[1], 75, 1e-12);
  EXPECT_NEAR(at(2.5)[0], 40 + 37.5, 1e-12);
  EXPECT_NEAR(at(12.5)[0], 40 + 37.5 + 1500, 1e-9);
  EXPECT_NEAR(at(12.5)[1], 150, 1e-12);
}

TEST(GearIn, HoldsItsLimitsBehindASteadyMaster) {
  test::Random random(17);
  for (int n = 0; n < 300; ++n) {
    const GearInSpec spec{.numerator = random.below(21) - 10,
                          .denominator = 1 + random.below(10),
                          .acceleration = random.log_uniform(10, 1e4),
                          .deceleration = random.log_uniform(10, 1e4),
                          .jerk = n % 3 == 0 ? 0 : random.log_uniform(100, 1e5)};
    const double w = random.uniform(-500, 500);
    const MotionState slave{random.uniform(-100, 100), random.uniform(-500, 500), 0};
    const auto master = [&](double t) { return Jet{10 + w * (t - 3), w, 0, 0}; };
    const GearedIn gear = gear_in(spec, slave, master(3), 3);
    const double T = gear.ramp.duration();
    Jet before = point(gear, master(3), 3);
    EXPECT_NEAR(before[0], slave.position, 1e-9);
    EXPECT_NEAR(before[1], slave.velocity, 1e-9);
    const double most = std::max(spec.acceleration, spec.deceleration) * (1 + 1e-9);
    for (int i = 1; i <= 200; ++i) {
      const double t = 3 + T * i / 199;
      const Jet now = point(gear, master(t), t);
      EXPECT_LE(std::abs(now[2]), most) << n;
      if (spec.jerk > 0) {
        EXPECT_LE(std::abs(now[3]), spec.jerk * (1 + 1e-9)) << n;
      }
      // Speeding up is under the acceleration, slowing down under the deceleration.
      if (now[1] * now[2] > 0 && spec.jerk == 0) {
        EXPECT_LE(std::abs(now[2]), spec.acceleration * (1 + 1e-9)) << n;
      }
      EXPECT_NEAR(now[0] - before[0], T / 199 * (now[1] + before[1]) / 2,
                  most * std::pow(T / 199, 2) + 1e-9)
          << n;
      before = now;
    }
    const Jet after = point(gear, master(3 + 2 * T + 1), 3 + 2 * T + 1);
    EXPECT_NEAR(after[1], gear.ratio * w, 1e-9);
    EXPECT_EQ(after[2], 0);
  }
}

TEST(GearIn, IsTheSameCycleByCycleAndAsACurve) {
  const Trajectory master =
      s_curve({.from = 5, .to = 400, .velocity = 120, .acceleration = 300, .jerk = 2000}).curve();
  const GearInSpec spec{.numerator = -5, .denominator = 3, .acceleration = 900, .jerk = 20000};
  for (const double t0 : {0.0, 0.1, 0.37, 1.2, 3.3}) {
    const Trajectory slave = gear_in(spec, 50, master, t0);
    EXPECT_EQ(slave.start(), master.start());
    EXPECT_TRUE(check_continuity(slave, 2).ok()) << t0;
    EXPECT_EQ(slave.at(t0 / 2).position, 50);
    const GearedIn gear = gear_in(spec, MotionState{50, 0, 0}, master.jet(t0), t0);
    for (int n = 0; n <= 1000; ++n) {
      const double t = t0 + (slave.end() - t0) * n / 1000;
      const Jet x = t <= master.end() ? master.jet(t) : Jet{400, 0, 0, 0};
      const Jet stepped = point(gear, x, t);
      const Jet exact = slave.jet(t);
      for (std::size_t k = 0; k < 3; ++k)
        EXPECT_NEAR(stepped[k], exact[k], 1e-9 * std::pow(100, k)) << t0 << " " << t;
    }
    EXPECT_NEAR(slave.at(slave.end()).velocity, 0, 1e-9);
  }
}

TEST(GearIn, IsReplacedByAnotherAndLetGo) {
  const auto master = [](double t) { return Jet{200 * t, 200, 0, 0}; };
  const GearInSpec first{.numerator = 1, .acceleration = 400, .jerk = 4000};
  const GearedIn one = gear_in(first, {}, master(0), 0);
  const Jet mid = point(one, master(0.3), 0.3);  // still ramping
  EXPECT_FALSE(in_gear(one, 0.3));
  GearInSpec other = first;
  other.numerator = -2;
  const GearedIn two = gear_in(other, {mid[0], mid[1], mid[2]}, master(0.3), 0.3);
  const Jet begun = point(two, master(0.3), 0.3);
  for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(begun[k], mid[k], 1e-9) << k;
  const double T = 0.3 + two.ramp.duration();
  const Jet settled = point(two, master(T + 1), T + 1);
  EXPECT_NEAR(settled[1], -400, 1e-9);
  const Released out = cam_out(settled, T + 1);  // GearOut
  EXPECT_NEAR(point(out, T + 3)[0], settled[0] - 800, 1e-9);
  EXPECT_NEAR(point(out, T + 3)[1], -400, 1e-9);
}

TEST(GearIn, RejectsInTheControllersNumbers) {
  const auto words = [](const GearInSpec& spec) -> std::string {
    return test::error_of([&] { gear_in(spec, {}, Jet{}, 0); });
  };
  EXPECT_EQ(words({.denominator = 0, .acceleration = 1}),
            "denominator = 0: must be greater than 0");
  EXPECT_EQ(words({}), "acceleration = 0: must be greater than 0, and finite (PMC600 error 676)");
  EXPECT_EQ(words({.acceleration = 1, .deceleration = -1}),
            "deceleration = -1: must be 0 or more, and finite (PMC600 error 677)");
  EXPECT_EQ(words({.acceleration = 1, .jerk = NAN}),
            "jerk = nan: must be 0 or more, and finite (PMC600 error 679)");
  const Trajectory master({line(1, 0, 1)});
  EXPECT_THROW(gear_in({.acceleration = 1}, 0, master, 1), InputError);
  const GearInSpec spec{.acceleration = 1};
  EXPECT_THROW(gear_in(spec, MotionState{NAN, 0, 0}, Jet{}, 0), InputError);
  EXPECT_THROW(gear_in(spec, MotionState{0, INFINITY, 0}, Jet{}, 0), InputError);
  EXPECT_THROW(gear_in(spec, MotionState{0, 0, NAN}, Jet{}, 0), InputError);
}

}  // namespace
}  // namespace jounce::gear_in_test
