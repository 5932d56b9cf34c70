// SPDX-License-Identifier: Apache-2.0
#include "jounce/profiles/vibration/notch.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "jounce/profiles/error.hpp"
#include "jounce/profiles/moves/s_curve.hpp"
#include "jounce/profiles/vibration/vibration.hpp"

#include "support/invariants.hpp"
#include "support/spring.hpp"

namespace jounce::notch_test {
namespace {

const double pi = std::acos(-1.0);

Trajectory move() {
  return s_curve({.from = 5, .to = 55, .velocity = 100, .acceleration = 1000, .jerk = 20000})
      .curve();
}

/// Integrates z'' + 2 D w z' + w^2 z = w^2 (f - f(start)) and forms the output
/// y = z + 2 D0 z'/w + z''/w^2, in which f enters twice; returns the worst difference from `got` at
/// the ends of all segments of f.
double worst_against_integration(const Trajectory& f, const NotchSpec& spec,
                                 const Trajectory& got) {
  const double w = 2 * pi * spec.frequency;
  const double origin = f.at(f.start()).position;
  test::Load z;
  double worst = 0;
  const auto run = [&](const Segment& piece, double t0) {
    const auto n = static_cast<int>(200 + 600 * w * piece.length);
    const auto bend = [&](double x, double v, double t) {
      return w * w * (value(piece, (t - t0) / piece.length) - origin - x) -
             2 * spec.damping * w * v;
    };
    z = test::integrated(z, t0, t0 + piece.length, n, bend);
    const double t = t0 + piece.length;
    const double y = z.x + 2 * spec.mode_damping * z.v / w + bend(z.x, z.v, t) / (w * w);
    worst = std::max(worst, std::abs(origin + y - got.at(t, Side::left).position));
  };
  for (std::size_t i = 0; i < f.segments().size(); ++i) run(f.segments()[i], f.breaks()[i]);
  const double rest = f.at(f.end()).position;
  const double step = (got.end() - f.end()) / 20;
  for (int i = 0; i < 20; ++i) run(line(step, rest, rest), f.end() + i * step);
  return worst;
}

TEST(Notch, MeetsAnIntegrationWithinItsStatedError) {
  for (const NotchSpec spec : {NotchSpec{5.5}, NotchSpec{5.5, 0.7, 0.03, 1e-9},
                               NotchSpec{40, 1.5, 0, 1e-4}, NotchSpec{0.4, 1, 0.1, 1e-3}}) {
    SCOPED_TRACE(spec.frequency);
    const Notched quiet = notched(move(), spec);
    EXPECT_LT(quiet.error, 20 * spec.settled * 50) << "the stated error is about the tail cut off";
    EXPECT_LT(worst_against_integration(move(), spec, quiet.motion), quiet.error + 1e-9);
    test::expect_invariants(quiet.motion, 2);
    EXPECT_EQ(quiet.motion.at(quiet.motion.start()).position, 5);
    EXPECT_NEAR(quiet.motion.at(quiet.motion.end()).position, 55, 1e-13);
  }
}

TEST(Notch, SilencesTheModeOfItsZeros) {
  for (const double D0 : {0.0, 0.03}) {
    const Notched quiet = notched(move(), {5.5, 1, D0, 1e-12});
    EXPECT_GT(residual_vibration(move(), {5.5, D0}), 0.2);
    EXPECT_LT(residual_vibration(quiet.motion, {5.5, D0}), 1e-9);
  }
}

TEST(Notch, TakesSinesAndSteps) {
  Segment f = line(1, 0, 10);
  f.sines = 1;
  f.sine[0] = {-10 / (2 * pi), 2 * pi, 0};
  const Trajectory cycloid({f});
  const NotchSpec spec{2, 1, 0, 1e-10};
  const Notched quiet = notched(cycloid, spec);
  EXPECT_LT(worst_against_integration(cycloid, spec, quiet.motion), quiet.error + 1e-10);
  const Trajectory step({line(0.2, 0, 0), line(0.3, 1, 1)});
  const Notched stepped = notched(step, spec);
  // The unit step through (s^2 + w^2)/(s + w)^2: 1 - 2 w t e^(-w t).
  const double w = 2 * pi * 2;
  for (const double t : {0.0, 0.1, 0.25})
    EXPECT_NEAR(stepped.motion.at(0.2 + t).position, 1 - 2 * w * t * std::exp(-w * t), 1e-13);
}

TEST(Notch, RejectsWhatItCannotFilter) {
  EXPECT_THROW(notched(move(), {.frequency = 0}), InputError);
  EXPECT_THROW(notched(move(), {5, 0.01}), InputError);
  EXPECT_THROW(notched(move(), {5, 1, 1}), InputError);
  EXPECT_THROW(notched(move(), {5, 1, 0, 0}), InputError);
  EXPECT_THROW(notched(move(), {.frequency = 1e9}), InputError);
  EXPECT_THROW(notched(with(move(), Extrapolation::wrap), {.frequency = 5}), InputError);
  EXPECT_THROW(notched(Trajectory({line(1, 2, 2)}), {.frequency = 5}), InputError);
}

}  // namespace
}  // namespace jounce::notch_test
