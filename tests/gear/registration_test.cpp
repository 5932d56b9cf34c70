// SPDX-License-Identifier: Apache-2.0
#include "jounce/gear/registration.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "jounce/gear/flying_shear.hpp"
#include "jounce/profiles/curve/extrema.hpp"
#include "jounce/profiles/error.hpp"
#include "jounce/profiles/limits/limits.hpp"

#include "support/errors.hpp"
#include "support/invariants.hpp"
#include "support/random.hpp"

namespace jounce::registration_test {
namespace {

/// A sealing roll: in step over 0...100 of each product of 300, then on to the next jaw at 360.
Cam roll() {
  return Cam({line(100, 0, 100), quintic(200, 100, 1, 0, 360, 1, 0)}, 0, Extrapolation::advance);
}

const Registration mark{.window_from = 120, .window_length = 150, .most = 2};

bool same(const Segment& f, const Segment& g) {
  return f.length == g.length && f.degree == g.degree && f.sines == g.sines && f.c == g.c;
}

TEST(Registration, CarriesWhatOneProductDoesNotAllow) {
  RegistrationState state;
  std::vector<double> steps;
  for (const double error : {5.0, 0.0, 0.0, 0.0, -3.0, 0.0}) {
    const Registered now = corrected(mark, state, error);
    steps.push_back(now.step);
    state = now.state;
  }
  EXPECT_EQ(steps, (std::vector<double>{2, 2, 1, 0, -2, -1}));
  EXPECT_EQ(state.applied, 2);
  EXPECT_EQ(state.outstanding, 0);
}

TEST(Registration, NothingCreeps) {
  test::Random random(3);
  RegistrationState state;
  double sum = 0;
  for (int i = 0; i < 1000000; ++i) {
    const double error = std::round(random.uniform(-4, 4) * 1024) / 1024;  // sums are exact
    sum += error;
    state = corrected(mark, state, error).state;
  }
  EXPECT_EQ(state.applied + state.outstanding, sum);
}

TEST(Registration, ZeroLeavesTheCamUntouchedToTheBit) {
  const Cam cam = roll();
  const std::vector<double> none(5, 0.0);
  const Cam all = registered(cam, mark, none);
  ASSERT_EQ(all.segments().size(), 10U);
  EXPECT_TRUE(same(all.segments()[0], cam.segments()[0]));
  EXPECT_TRUE(same(all.segments()[1], cam.segments()[1]));
  EXPECT_EQ(all.end(), 1500);
  const Cam late =
      registered(with(cam, Extrapolation::wrap), mark, none);  // comes back: no shift either
  for (std::size_t i = 0; i < 10; ++i)
    EXPECT_TRUE(same(late.segments()[i], cam.segments()[i % 2])) << i;
}

TEST(Registration, NeverDisturbsASyncZone) {
  test::Random random(11);
  std::vector<double> errors;
  for (int i = 0; i < 60; ++i) errors.push_back(random.uniform(-5, 5));
  const Cam all = registered(roll(), mark, errors);
  test::expect_invariants(all, 2);
  RegistrationState state;
  for (std::size_t n = 0; n < errors.size(); ++n) {
    const double from = 300.0 * static_cast<double>(n);
    for (const double x : {0.0, 37.5, 99.0}) {
      const Jet at = all.jet(from + x);
      EXPECT_NEAR(at[0], 360.0 * static_cast<double>(n) + x + state.applied, 1e-9);
      EXPECT_NEAR(at[1], 1, 1e-13);
      EXPECT_NEAR(at[2], 0, 1e-15);
    }
    state = corrected(mark, state, errors[n]).state;
  }
}

TEST(Registration, FollowsADriftAndForgetsNoise) {
  // The marks move by 0.7 a product, begin 20 off, and are measured with noise.
  test::Random random(7);
  for (const double noise : {0.0, 0.1}) {
    RegistrationState state;
    double off = 0;
    for (int n = 0; n < 200; ++n) {
      const double mark_at = 20 + 0.7 * n;
      off = mark_at - state.applied;
      const double seen = off + random.uniform(-noise, noise);
      state = corrected(mark, state, seen - state.outstanding).state;
      if (n > 20) {
        EXPECT_NEAR(off, 0.7, noise + 1e-12) << n;
      }  // one product behind, no more
    }
  }
}

TEST(Registration, TheGreatestCorrectionIsTheClosedForm) {
  // On a roll at constant speed v the law adds Cv s v / b and Ca s v^2 / b^2.
  const Cam even({line(300, 0, 300)}, 0, Extrapolation::advance);
  Registration wide = mark;
  wide.most = 1e6;
  const double v = 500;
  const double b = mark.window_length;
  const double ca = 10 / std::sqrt(3.0);
  EXPECT_NEAR(greatest_correction(even, wide, {.velocity = 600}, v), 0.2 * b / (15.0 / 8), 1e-3);
  wide.most = 100;
  EXPECT_NEAR(greatest_correction(even, wide, {.velocity = 600}, v), 0.2 * b / (15.0 / 8), 1e-7);
  EXPECT_NEAR(greatest_correction(even, wide, {.acceleration = 1000}, v),
              1000 * b * b / (ca * v * v), 1e-7);
  EXPECT_EQ(greatest_correction(even, wide, {.velocity = 400}, v), 0);
  EXPECT_EQ(greatest_correction(even, wide, {}, v), 100);
}

TEST(Registration, StaysWithinItsStatedLimits) {
  const Cam cam = roll();
  Registration wide = mark;
  wide.most = 1000;
  const double v = 100;
  Limits slave{.velocity = 200, .acceleration = 300};
  wide.most = greatest_correction(cam, wide, slave, v);
  EXPECT_GT(wide.most, 0);
  EXPECT_LT(wide.most, 1000);
  const std::vector<double> errors{wide.most, -wide.most};
  const Cam all = registered(cam, wide, errors);
  EXPECT_LE(std::abs(extrema(all, 1).peak().value) * v, 200 * (1 + 1e-9));
  EXPECT_LE(std::abs(extrema(all, 2).peak().value) * v * v, 300 * (1 + 1e-9));
  const std::vector<double> more{1.001 * wide.most, -2.002 * wide.most};
  wide.most *= 1.002;
  const Cam broken = registered(cam, wide, more);
  EXPECT_TRUE(std::abs(extrema(broken, 1).peak().value) * v > 200 ||
              std::abs(extrema(broken, 2).peak().value) * v * v > 300);
}

TEST(Registration, AShearIsMovedByItsPhase) {
  FlyingShear spec{.cut_length = 1000, .line_speed = 1000, .sync_time = 0.15};
  spec.limits.acceleration = 10000;
  spec.return_length = 450;
  spec.cut_length = 1200;
  const SyncCam shear = flying_shear(spec);
  const ShearPlan plan = shear_plan(spec);
  const double wait_from = spec.cut_length - plan.wait;
  const std::vector<double> errors{3.0, -1.0, 0.0};
  // While it waits at home a correction moves nothing: exact.
  const Registration waiting{.window_from = wait_from, .window_length = plan.wait - 10, .most = 5};
  const auto exact = registered_phase(shear.cam, waiting, errors, 1e-6);
  EXPECT_EQ(exact.error[0], 0);
  for (double x = 0; x < 1000; x += 37.5) {
    EXPECT_NEAR(exact.curve.jet(x)[0], shear.cam.jet(x)[0], 1e-11);
    EXPECT_NEAR(exact.curve.jet(1200 + x)[0], shear.cam.jet(x + 3)[0], 1e-9);
    EXPECT_NEAR(exact.curve.jet(2400 + x)[0], shear.cam.jet(x + 2)[0], 1e-9);
  }
  // While it returns: within the tolerance, certified; in step the ratio is untouched.
  const Registration returning{.window_from = plan.accelerate + plan.sync + plan.decelerate,
                               .window_length = plan.back,
                               .most = 5};
  const auto fitted = registered_phase(shear.cam, returning, errors, 1e-6);
  EXPECT_GT(fitted.error[0], 0);
  EXPECT_LE(fitted.error[0], 1e-6);
  EXPECT_TRUE(check_continuity(fitted.curve, 2).ok());
  const SyncZone zone = shear.zones.at(0);
  for (double x = zone.from + 5; x < zone.to - 5; x += 10) {
    EXPECT_NEAR(fitted.curve.jet(1200 + x)[1], 1, 1e-12);
    EXPECT_NEAR(fitted.curve.jet(1200 + x)[0], shear.cam.jet(x + 3)[0], 1e-9);
  }
  const double z = 0.5 * (plan.back - 3);  // half way: c = 1.5 by symmetry, cam(x + 1.5)
  EXPECT_NEAR(fitted.curve.jet(returning.window_from + z)[0],
              shear.cam.jet(returning.window_from + z + 1.5)[0], 2e-6);
}

TEST(Registration, NoSyncZoneIsDisturbedHoweverLongAnErrorLasts) {
  FlyingShear spec{.cut_length = 1000, .line_speed = 1000, .sync_time = 0.15};
  spec.limits.acceleration = 10000;
  const SyncCam shear = flying_shear(spec);
  const SyncZone zone = shear.zones.at(0);
  // From the end of the sync zone to the period's end: it may touch the zone.
  const Registration after{.window_from = zone.to, .window_length = 1000 - zone.to, .most = 2};
  for (const double error : {2.0, -2.0}) {
    const std::vector<double> errors(1000, error);
    const auto fitted = registered_phase(shear.cam, after, errors, 1e-4);
    const Cam& all = fitted.curve;
    ASSERT_NEAR(all.length(), 1000 * (1000 - error), 1e-6);
    double worst = 0;
    for (int n = 0; n < 1000; ++n) {
      const double from = n * (1000 - error);  // start of the period of the phase
      for (const double x : {zone.from + 1e-6, (zone.from + zone.to) / 2, zone.to - 1e-6}) {
        const Jet at = all.jet(from + x);
        worst = std::max(worst, std::abs(at[1] - 1));
        ASSERT_NEAR(at[0], shear.cam.jet(x)[0], 1e-6) << error << ", product " << n;
      }
    }
    EXPECT_LT(worst, 1e-9) << error;
  }
}

TEST(Registration, AShearContinuesFromAState) {
  FlyingShear spec{.cut_length = 1000, .line_speed = 1000, .sync_time = 0.15};
  spec.limits.acceleration = 10000;
  const SyncCam shear = flying_shear(spec);
  const Registration after{.window_from = 525, .window_length = 400, .most = 2};
  const std::vector<double> errors{2, 5, -1, 0};
  const auto whole = registered_phase(shear.cam, after, errors, 1e-4);
  RegistrationState state;
  for (const double error : {2.0, 5.0}) state = corrected(after, state, error).state;
  const auto rest = registered_phase(shear.cam, after, std::vector<double>{-1, 0}, 1e-4, state);
  EXPECT_EQ(rest.curve.start(), -4);
  for (double x = 0; x < 1990; x += 7)
    EXPECT_NEAR(rest.curve.jet(x)[0], whole.curve.jet(2000 + x)[0], 2.1e-4) << x;
  Registration wide = after;
  wide.most = 400;
  EXPECT_THROW(registered_phase(shear.cam, wide, errors, 1e-4), InputError);
}

std::string refusal(const Registration& registration, const Cam& cam, double error) {
  return test::error_of([&] { registered(cam, registration, std::vector<double>{error}); });
}

TEST(Registration, ReportsContradictions) {
  using ::testing::StartsWith;
  Registration bad = mark;
  bad.window_length = 200;
  EXPECT_THAT(refusal(bad, roll(), 1), StartsWith("window_length = 200: must be at most 180"));
  bad = mark;
  bad.most = 0;
  EXPECT_THAT(refusal(bad, roll(), 1), StartsWith("most = 0"));
  bad = mark;
  bad.law = Law::line;
  EXPECT_THAT(refusal(bad, roll(), 1), StartsWith("law = line"));
  EXPECT_THAT(refusal(mark, roll(), std::nan("")), StartsWith("error = nan"));
  EXPECT_THAT(refusal(mark, with(roll(), Extrapolation::hold), 1), StartsWith("cam: must wrap"));
}

}  // namespace
}  // namespace jounce::registration_test
