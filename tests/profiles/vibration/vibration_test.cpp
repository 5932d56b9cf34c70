// SPDX-License-Identifier: Apache-2.0
#include "jounce/profiles/vibration/vibration.hpp"

#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "jounce/profiles/error.hpp"
#include "jounce/profiles/moves/s_curve.hpp"

#include "support/random.hpp"
#include "support/spring.hpp"

namespace jounce::vibration_test {
namespace {

using test::after;
const double pi = std::acos(-1.0);

/// The envelope of a free vibration about rest at `place`: conserved by the motion but for its decay.
double envelope(const test::Load& load, double place, const Mode& mode) {
  const double w = 2 * pi * mode.frequency;
  const double root = std::sqrt(1 - mode.damping * mode.damping);
  const double x = load.x - place;
  return std::hypot(x, (load.v + mode.damping * w * x) / (w * root));
}

TEST(Vibration, OfAStepIsTheStep) {
  const Trajectory step({line(1, 0, 0), line(1e-9, 3, 3)});
  EXPECT_NEAR(residual_vibration(step, {5, 0}), 3, 1e-12);
}

TEST(Vibration, OfARampIsTheClosedForm) {
  // v L over time L, undamped: v/w |1 - e^(iwL)| = 2 v/w |sin(wL/2)|.
  for (const double f0 : {0.01, 0.4, 3.7, 250.0}) {
    const double w = 2 * pi * f0;
    EXPECT_NEAR(residual_vibration(Trajectory({line(2, 0, 5)}), {f0, 0}),
                2 * 2.5 / w * std::abs(std::sin(w)), 1e-13 * 5);
  }
}

TEST(Vibration, MeetsAnIntegrationOfTheSpring) {
  test::Random random(5);
  for (int i = 0; i < 12; ++i) {
    const Mode mode{random.log_uniform(0.2, 20), i % 3 == 0 ? 0 : random.uniform(0, 0.6)};
    SCOPED_TRACE(::testing::Message() << mode.frequency << " Hz, " << mode.damping);
    const Trajectory move = s_curve({.to = 1,
                                     .velocity = random.log_uniform(0.5, 5),
                                     .acceleration = random.log_uniform(2, 20),
                                     .jerk = random.log_uniform(10, 1000)})
                                .curve();
    EXPECT_NEAR(residual_vibration(move, mode), envelope(after(move, mode), 1, mode), 1e-11);
  }
}

TEST(Vibration, CountsTheSinesOfACycloid) {
  Segment f = line(1.3, 0, 2);
  f.sines = 1;
  f.sine[0] = {-2 / (2 * pi), 2 * pi, 0};
  const Trajectory cycloid({f});
  for (const Mode mode : {Mode{0.5, 0}, Mode{1 / 1.3, 0}, Mode{1 / 1.3 * (1 + 1e-9), 0},
                          Mode{2.2, 0.1}, Mode{30, 0.02}}) {
    SCOPED_TRACE(mode.frequency);
    EXPECT_NEAR(residual_vibration(cycloid, mode), envelope(after(cycloid, mode), 2, mode), 1e-11);
  }
}

TEST(Vibration, DoesNotDependOnHowACurveIsCut) {
  const Trajectory move =
      s_curve({.to = 1, .velocity = 2, .acceleration = 10, .jerk = 100}).curve();
  std::vector<Segment> pieces;
  for (const Segment& f : move.segments())
    for (int i = 0; i < 50; ++i) pieces.push_back(part(f, i / 50.0, (i + 1) / 50.0));
  for (const double f0 : {0.1, 1.0, 10.0, 100.0})
    EXPECT_NEAR(residual_vibration(Trajectory(pieces), {f0, 0.05}),
                residual_vibration(move, {f0, 0.05}), 1e-13);
}

TEST(Vibration, WorstOfABandIsNotMissed) {
  // One impulse after 1 s, equal: |cos(pi f)|, greatest at whole f.
  const std::array pair{Impulse{0, 0.5}, Impulse{1, 0.5}};
  EXPECT_NEAR(worst_residual(pair, 0, 0.3, 0.7).residual, std::cos(0.3 * pi), 1e-6);
  EXPECT_NEAR(worst_residual(pair, 0, 0.3, 3.2).residual, 1, 1e-6);
  EXPECT_NEAR(worst_residual(pair, 0, 0.5, 0.5).residual, 0, 1e-15);
  EXPECT_THROW(worst_residual(pair, 0, 2, 1), InputError);
  EXPECT_THROW(worst_residual(pair, 0, 0, 1), InputError);
  EXPECT_THROW(worst_residual(pair, 1, 1, 2), InputError);
  EXPECT_THROW(residual_vibration(std::span<const Impulse>{}, {1, 0}), InputError);
}

TEST(Vibration, RejectsImpulsesThatAreNone) {
  const auto left = [](Impulse a, Impulse b) {
    return residual_vibration(std::array{a, b}, {5, 0});
  };
  EXPECT_THROW(left({0, NAN}, {1, 0.5}), InputError);
  EXPECT_THROW(left({0, 0.5}, {INFINITY, 0.5}), InputError);
  EXPECT_THROW(left({-1, 0.5}, {1, 0.5}), InputError);
  EXPECT_THROW(left({1, 0.5}, {0, 0.5}), InputError);
}

}  // namespace
}  // namespace jounce::vibration_test
