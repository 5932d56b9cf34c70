// SPDX-License-Identifier: Apache-2.0
#include "jounce/cam/coupling/master_limits.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "jounce/cam/design/design.hpp"
#include "jounce/profiles/curve/extrema.hpp"
#include "jounce/profiles/error.hpp"

#include "cam/laws/laws.hpp"
#include "support/fig_6_14.hpp"
#include "support/random.hpp"

namespace jounce::master_limits_test {
namespace {

Cam placed(const char* name, double stroke, double length) {
  return scaled(test::laws().at(name), stroke, length);
}

TEST(GreatestMasterVelocity, IsTheLeastOfThreeRoots) {
  const Cam cam = placed("poly_345", 50, 120);
  const double v = 15.0 / 8 * 50 / 120;
  const double a = 10 / std::sqrt(3) * 50 / (120 * 120);
  const double j = 60.0 * 50 / (120 * 120 * 120);
  const auto velocity = greatest_master_velocity(cam, {.velocity = 200});
  EXPECT_NEAR(velocity.value, 200 / v, 1e-12 * 200 / v);
  EXPECT_EQ(velocity.quantity, "velocity");
  EXPECT_NEAR(velocity.where, 60, 1e-6);
  const auto acceleration = greatest_master_velocity(cam, {.velocity = 200, .acceleration = 1000});
  EXPECT_NEAR(acceleration.value, std::sqrt(1000 / a), 1e-12 * acceleration.value);
  EXPECT_EQ(acceleration.quantity, "acceleration");
  const auto jerk =
      greatest_master_velocity(cam, {.velocity = 200, .acceleration = 1000, .jerk = 5000});
  EXPECT_NEAR(jerk.value, std::cbrt(5000 / j), 1e-12 * jerk.value);
  EXPECT_EQ(jerk.quantity, "jerk");
}

TEST(GreatestMasterVelocity, IsInfiniteWithoutLimitsAndZeroWhereADerivativeSteps) {
  const Cam cam = placed("simple_sine", 1, 1);
  EXPECT_TRUE(std::isinf(greatest_master_velocity(cam, {}).value));
  EXPECT_GT(greatest_master_velocity(cam, {.acceleration = 1}).value, 0);
  const auto none = greatest_master_velocity(cam, {.acceleration = 1, .jerk = 1});
  EXPECT_EQ(none.value, 0);
  EXPECT_EQ(none.quantity, "jerk");
  const Cam gear({line(1, 0, 2)});
  EXPECT_TRUE(std::isinf(greatest_master_velocity(gear, {.acceleration = 1, .jerk = 1}).value));
  EXPECT_EQ(greatest_master_velocity(with(gear, Extrapolation::wrap), {.velocity = 1}).value, 0)
      << "it jumps back where it wraps";
  const auto kick = greatest_master_velocity(with(gear, Extrapolation::hold), {.acceleration = 1});
  EXPECT_EQ(kick.value, 0) << "from rest to 2 at once";
  EXPECT_EQ(kick.quantity, "acceleration");
}

/// A step of f'' by s is permitted up to s w^2 = J T, and a step of f' by s up to s w = A T.
TEST(GreatestMasterVelocity, PermitsAStepWithinOneCycle) {
  const Cam cam = placed("simple_sine", 1, 1);  // its acceleration begins with pi^2 / 2
  const double step = std::numbers::pi * std::numbers::pi / 2;
  const auto limit = greatest_master_velocity(cam, {.jerk = 10}, {.cycle = 1e-3});
  EXPECT_NEAR(limit.value, std::sqrt(10 * 1e-3 / step), 1e-9 * limit.value);
  EXPECT_TRUE(limit.is_step);
  EXPECT_EQ(limit.quantity, "jerk");
  EXPECT_EQ(greatest_master_acceleration(cam, {.jerk = 10}, 2 * limit.value, 0, 1e-3).value, 0);
  EXPECT_GT(greatest_master_acceleration(cam, {.jerk = 10}, limit.value / 2, 0, 1e-3).value, 0);
  const Cam kick = with(Cam({line(1, 0, 2)}), Extrapolation::hold);
  const auto speed = greatest_master_velocity(kick, {.acceleration = 10}, {.cycle = 1e-3});
  EXPECT_NEAR(speed.value, 10 * 1e-3 / 2, 1e-15);
  EXPECT_TRUE(speed.is_step);
  const Cam back = with(Cam({line(1, 0, 2)}), Extrapolation::wrap);
  EXPECT_EQ(greatest_master_velocity(back, {.velocity = 1}, {.cycle = 1e-3}).value, 0)
      << "a step of the position is never permitted";
  EXPECT_FALSE(
      greatest_master_velocity(placed("poly_345", 1, 1), {.jerk = 10}, {.cycle = 1e-3}).is_step);
}

TEST(GreatestMasterAcceleration, OfAStraightLineIsTheSlavesOverTheRatio) {
  const Cam gear({line(10, 0, 20)});
  const auto a = greatest_master_acceleration(gear, {.velocity = 5, .acceleration = 8}, 1);
  EXPECT_DOUBLE_EQ(a.value, 4);
  EXPECT_EQ(greatest_master_acceleration(gear, {.velocity = 5, .acceleration = 8}, 3).value, 0)
      << "3 m/s is too fast already";
  const auto v = greatest_master_velocity(gear, {.velocity = 5, .acceleration = 8}, {3, 0});
  EXPECT_DOUBLE_EQ(v.value, 2.5);
  EXPECT_EQ(greatest_master_velocity(gear, {.acceleration = 8}, {5, 0}).value, 0);
}

TEST(GreatestMasterAcceleration, OfTheCycloidHasItsClosedForm) {
  // |f''| w^2 + |f'| a <= A with f' = 1 - cos t, f'' = 2 pi sin t; in u = w^2, over t. At w = 0 the
  // limit is A / 2; at A = 2 pi w^2 it is reached where f' = 1, and no margin is left.
  const Cam cam = placed("inclined_sine", 1, 1);
  EXPECT_NEAR(greatest_master_acceleration(cam, {.acceleration = 10}, 0).value, 5, 1e-12);
  // For A = 1, w^2 = q: least over t of (1 - 2 pi q sin t) / (1 - cos t); with p = 2 pi q the
  // derivative vanishes where p (1 - cos t) = sin t, that is tan(t/2) = 1/p: the value is then
  // (1 - p sin t) / (1 - cos t) with sin t = 2p/(1+p^2), 1 - cos t = 2/(1+p^2): (1 - p^2) / 2.
  for (const double p : {0.1, 0.5, 0.9, 0.999}) {
    const double w = std::sqrt(p / (2 * std::acos(-1.0)));
    const auto a = greatest_master_acceleration(cam, {.acceleration = 1}, w);
    EXPECT_NEAR(a.value, (1 - p * p) / 2, 1e-12) << p;
    EXPECT_NEAR(std::abs(std::tan(std::acos(-1.0) * a.where)), 1 / p, 1e-5 / p) << p;
    // And back: with that acceleration the greatest speed is w.
    EXPECT_NEAR(greatest_master_velocity(cam, {.acceleration = 1}, {a.value, 0}).value, w, 1e-12);
  }
}

/// The slave's greatest velocity, acceleration, jerk over a fine grid and all signs.
std::array<double, 3> sampled(const Cam& cam, double w, double a, double j) {
  std::array<double, 3> most{};
  for (const Segment& f : cam.segments())
    for (int i = 0; i <= 400; ++i) {
      const Jet g = evaluate(f, i / 400.0);
      most[0] = std::max(most[0], std::abs(g[1]) * w);
      most[1] = std::max(most[1], std::abs(g[2]) * w * w + std::abs(g[1]) * a);
      most[2] = std::max(
          most[2], std::abs(g[3]) * w * w * w + 3 * std::abs(g[2]) * w * a + std::abs(g[1]) * j);
    }
  return most;
}

TEST(MasterLimits, AreReachedAndNotPassedOnRandomCams) {
  test::Random random(30);
  const std::vector<const char*> names{"poly_345",      "modified_sine", "poly_4567",
                                       "inclined_sine", "gutman_13",     "modified_trapezoid"};
  for (int n = 0; n < 1000; ++n) {
    SCOPED_TRACE(n);
    const double stroke = random.log_uniform(1e-3, 1e3);
    const double length = random.log_uniform(1e-3, 1e3);
    const Cam rise = placed(names[static_cast<std::size_t>(random.below(6))], stroke, length);
    const Cam fall =
        shifted(scaled(test::laws().at(names[static_cast<std::size_t>(random.below(6))]), -stroke,
                       length * random.uniform(0.5, 2)),
                0, stroke);
    const Cam cam = with(concatenated(rise, fall), Extrapolation::wrap);
    const Ranges r = extrema(cam);
    const double w = random.log_uniform(1e-2, 1e2) * length;  // in the order of what is asked
    const Limits slave{.velocity = r[1].peak().value * w * random.uniform(1, 3),
                       .acceleration = std::abs(r[2].peak().value) * w * w * random.uniform(1, 3),
                       .jerk = std::abs(r[3].peak().value) * w * w * w * random.uniform(1, 3)};
    const Limits positive{.velocity = std::abs(*slave.velocity),
                          .acceleration = slave.acceleration,
                          .jerk = slave.jerk};
    const double jerk =
        random.below(2) == 0 ? 0 : 0.1 * *positive.jerk / std::abs(r[1].peak().value);
    const auto check = [&](double speed, double acceleration, double rate,
                           const MasterLimit& limit) {
      const auto most = sampled(cam, speed, acceleration, rate);
      const std::array share{most[0] / *positive.velocity, most[1] / *positive.acceleration,
                             most[2] / *positive.jerk};
      const double worst = *std::max_element(share.begin(), share.end());
      EXPECT_LE(worst, 1 + 1e-12) << "nothing passes its limit";
      EXPECT_GE(worst, 1 - 1e-3) << "and a fine grid comes close";
      const std::size_t k = limit.quantity == "velocity" ? 0 : (limit.quantity == "jerk" ? 2 : 1);
      EXPECT_GE(share[k], 1 - 1e-3) << limit.quantity << " binds";
    };
    const auto ramp = greatest_master_acceleration(cam, positive, w * 0.9, jerk);
    ASSERT_GE(ramp.value, 0);
    if (ramp.value > 0) check(w * 0.9, ramp.value, jerk, ramp);
    const double ability = 0.3 * *positive.acceleration / std::abs(r[1].peak().value);
    const auto speed = greatest_master_velocity(cam, positive, {ability, jerk});
    if (speed.value > 0) check(speed.value, ability, jerk, speed);
    EXPECT_LE(speed.value, greatest_master_velocity(cam, positive).value);
  }
}

TEST(MasterLimits, FindANarrowPeakThatAThousandSamplesMiss) {
  // A dwell with a bump of width 0.2 between two samples of a thousand.
  const double start = 360.0 * 500 / 1000 + 0.05;
  const double width = 0.2;
  const Cam cam({line(start, 0, 0), quintic(width / 2, 0, 0, 0, 1e-3, 0, 0),
                 quintic(width / 2, 1e-3, 0, 0, 0, 0, 0), line(360 - start - width, 0, 0)},
                0, Extrapolation::wrap);
  for (int i = 0; i <= 1000; ++i) EXPECT_EQ(cam.jet(360.0 * i / 1000)[1], 0);
  const auto limit = greatest_master_velocity(cam, {.velocity = 1});
  EXPECT_NEAR(limit.value, width / 2 / 1e-3 / 1.875, 1e-9);
  EXPECT_NEAR(limit.where, start + width / 4, 1e-9);
}

TEST(MasterLimits, RejectsAnInvalidLimit) {
  const Cam cam({line(1, 0, 1)});
  EXPECT_THROW((void)greatest_master_velocity(cam, {.velocity = 0}), InputError);
  EXPECT_THROW((void)greatest_master_velocity(cam, {}, {-1, 0}), InputError);
  EXPECT_THROW((void)greatest_master_acceleration(cam, {}, -1), InputError);
}

}  // namespace
}  // namespace jounce::master_limits_test
