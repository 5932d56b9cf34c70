// SPDX-License-Identifier: Apache-2.0
#include "jounce/profiles/vibration/shaper.hpp"

#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "jounce/profiles/error.hpp"
#include "jounce/profiles/moves/s_curve.hpp"

#include "support/invariants.hpp"
#include "support/spring.hpp"

namespace jounce::shaper_test {
namespace {

const double pi = std::acos(-1.0);

double total(const std::vector<Impulse>& impulses) {
  double sum = 0;
  for (const Impulse& x : impulses) sum += x.amplitude;
  return sum;
}

Trajectory move() {
  return s_curve({.to = 50, .velocity = 100, .acceleration = 1000, .jerk = 20000}).curve();
}

TEST(Shaper, UndampedZvIsTwoHalvesHalfAPeriodApart) {
  const auto zv = shaper({ShaperKind::zv, {4, 0}});
  ASSERT_EQ(zv.size(), 2U);
  EXPECT_EQ(zv[0].amplitude, 0.5);
  EXPECT_EQ(zv[1].amplitude, 0.5);
  EXPECT_EQ(zv[1].time, 0.125);
}

TEST(Shaper, DetuningFollowsTheCosine) {
  // Undamped: zv leaves |cos(pi f / (2 f0))|, zvd its square, ei |b + 2 a cos(pi f / f0)| with
  // a = (1 + V)/4, b = (1 - V)/2.
  const double f0 = 5.5;
  const double V = 0.05;
  const auto zv = shaper({ShaperKind::zv, {f0, 0}});
  const auto zvd = shaper({ShaperKind::zvd, {f0, 0}});
  const auto ei = shaper({ShaperKind::ei, {f0, 0}, V});
  for (double f = 0.2 * f0; f < 3 * f0; f += 0.05 * f0) {
    const double c = std::abs(std::cos(pi * f / (2 * f0)));
    EXPECT_NEAR(residual_vibration(zv, {f, 0}), c, 1e-14) << f;
    EXPECT_NEAR(residual_vibration(zvd, {f, 0}), c * c, 1e-14) << f;
    EXPECT_NEAR(residual_vibration(ei, {f, 0}),
                std::abs((1 - V) / 2 + (1 + V) / 2 * std::cos(pi * f / f0)), 1e-14);
  }
}

TEST(Shaper, IsAsInsensitiveAsInItsTextbook) {
  // Half the width of the band in which less than 5 % is left, from the formulas above.
  const auto width = [](ShaperKind kind, double half) {
    const auto impulses = shaper({kind, {1, 0}, 0.05});
    EXPECT_NEAR(worst_residual(impulses, 0, 1 - half, 1 + half).residual, 0.05, 2e-6);
    EXPECT_GT(worst_residual(impulses, 0, 1 - 1.02 * half, 1 + half).residual, 0.0505);
  };
  width(ShaperKind::zv, 2 / pi * std::asin(0.05));
  width(ShaperKind::zvd, 2 / pi * std::asin(std::sqrt(0.05)));
  width(ShaperKind::ei, 1 - std::acos((0.05 - 0.475) / 0.525) / pi);
}

TEST(Shaper, LeavesNothingOfADampedMode) {
  for (const double D : {0.0, 0.03, 0.15, 0.3, 0.7}) {
    const Mode mode{5.5, D};
    EXPECT_NEAR(residual_vibration(shaper({ShaperKind::zv, mode}), mode), 0, 1e-15);
    EXPECT_NEAR(residual_vibration(shaper({ShaperKind::zvd, mode}), mode), 0, 1e-15);
    // zvd: nor does a small change bring any, to first order.
    const auto zvd = shaper({ShaperKind::zvd, mode});
    EXPECT_LT(residual_vibration(zvd, {5.5 * (1 + 1e-4), D}), 1e-6);
  }
  for (const double D : {0.0, 0.03, 0.15, 0.3}) {
    const auto ei = shaper({ShaperKind::ei, {5.5, D}, 0.05});
    EXPECT_NEAR(residual_vibration(ei, {5.5, D}), 0.05, 1e-15);
    EXPECT_NEAR(total(ei), 1, 1e-15);
    for (const Impulse& x : ei) EXPECT_GT(x.amplitude, 0);
  }
}

TEST(Shaper, AShapedMoveLeavesNothing) {
  for (const double D : {0.0, 0.03, 0.2})
    for (const ShaperKind kind : {ShaperKind::zv, ShaperKind::zvd}) {
      const Mode mode{5.5, D};
      const Trajectory quiet = shaped(move(), shaper({kind, mode}));
      EXPECT_GT(residual_vibration(move(), mode), 0.2) << "the move excites the mode";
      EXPECT_LT(residual_vibration(quiet, mode), 1e-12 * 50);
      const test::Load load = test::after(quiet, mode);
      EXPECT_NEAR(load.x, 50, 1e-9) << "the integrated spring agrees";
      EXPECT_NEAR(load.v, 0, 1e-7);
    }
}

TEST(Shaper, ResidualOfTheCurveIsThatOfTheMoveTimesThatOfTheImpulses) {
  const auto impulses = shaper({ShaperKind::ei, {5.5, 0.03}, 0.05});
  for (const Mode mode : {Mode{4, 0}, Mode{5.5, 0.03}, Mode{6.3, 0.1}, Mode{40, 0.01}}) {
    const double product = residual_vibration(move(), mode) * residual_vibration(impulses, mode);
    EXPECT_NEAR(residual_vibration(shaped(move(), impulses), mode), product, 1e-12 * 50);
  }
}

TEST(Shaper, ShapedIsTheSumOfDelayedCopies) {
  const Trajectory f = shifted(move(), 2, -7);
  const auto impulses = shaper({ShaperKind::zvd, {3, 0.1}});
  const Trajectory g = shaped(f, impulses);
  const Trajectory held = with(f, Extrapolation::hold);
  EXPECT_EQ(g.start(), 2);
  EXPECT_NEAR(g.end(), f.end() + impulses.back().time, 1e-14);
  for (int i = 0; i <= 500; ++i) {
    const double t = g.start() + g.length() * i / 500;
    double expected = 0;
    for (const Impulse& x : impulses) expected += x.amplitude * held.at(t - x.time).position;
    EXPECT_NEAR(g.at(t).position, expected, 1e-13 * 50);
  }
  EXPECT_TRUE(check(g, {.velocity = 100, .acceleration = 1000, .jerk = 20000}).ok());
  test::expect_invariants(g, 2);
}

TEST(Shaper, TakesSinesAndWrappingCurves) {
  Segment f = line(2, 0, 10);
  f.sines = 1;
  f.sine[0] = {-10 / (2 * pi), 2 * pi, 0};
  const auto zvd = shaper({ShaperKind::zvd, {3.3, 0}});
  const Trajectory cycloid({f});
  EXPECT_LT(residual_vibration(shaped(cycloid, zvd), {3.3, 0}), 1e-12 * 10);
  test::expect_invariants(shaped(cycloid, zvd), 2);
  const Trajectory turn = with(concatenated(cycloid, reversed(cycloid)), Extrapolation::wrap);
  const Trajectory g = shaped(turn, zvd);
  EXPECT_EQ(g.outside(), Extrapolation::wrap);
  EXPECT_NEAR(g.length(), 4, 1e-14);
  EXPECT_TRUE(check_continuity(g, 2).ok());
}

TEST(Shaper, TwoModesAtOnce) {
  const Mode a{5, 0.02};
  const Mode b{13, 0.05};
  const auto both = convolved(shaper({ShaperKind::zv, a}), shaper({ShaperKind::zv, b}));
  EXPECT_NEAR(total(both), 1, 1e-15);
  const Trajectory quiet = shaped(move(), both);
  EXPECT_LT(residual_vibration(quiet, a), 1e-12 * 50);
  EXPECT_LT(residual_vibration(quiet, b), 1e-12 * 50);
  const auto zv = shaper({ShaperKind::zv, a});
  const auto zvd = shaper({ShaperKind::zvd, a});
  const auto twice = convolved(zv, zv);  // zv twice is zvd
  ASSERT_EQ(twice.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(twice[i].amplitude, zvd[i].amplitude, 1e-15);
}

TEST(Shaper, RejectsAMovingEndAndCopiesOutOfReach) {
  const auto zv = shaper({ShaperKind::zv, {5.5, 0}});
  const Trajectory jog({quintic(0.1, 0, 0, 0, 1, 10, 0), line(1, 1, 11)});
  EXPECT_THROW(shaped(jog, zv), InputError) << "it would be stopped in no time";
  EXPECT_THROW(shaped(move(), std::array{Impulse{0, 0.5}, Impulse{1e20, 0.5}}), InputError);
}

TEST(Shaper, RejectsWhatIsNoShaper) {
  EXPECT_THROW(shaper({ShaperKind::zv, {0, 0}}), InputError);
  EXPECT_THROW(shaper({ShaperKind::zv, {5, 1}}), InputError);
  EXPECT_THROW(shaper({ShaperKind::ei, {5, 0}, 0}), InputError);
  EXPECT_THROW(shaper({ShaperKind::ei, {5, 0.9}, 0.05}), InputError) << "damped out by itself";
  EXPECT_THROW(shaped(move(), {}), InputError);
  EXPECT_THROW(shaped(move(), std::array{Impulse{0.1, 1}}), InputError);
  EXPECT_THROW(shaped(move(), std::array{Impulse{0, 0.5}, Impulse{1, 0.4}}), InputError);
}

}  // namespace
}  // namespace jounce::shaper_test
