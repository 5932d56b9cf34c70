// SPDX-License-Identifier: Apache-2.0
#include "jounce/profiles/vibration/vibration_band.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "jounce/profiles/error.hpp"
#include "jounce/profiles/moves/s_curve.hpp"
#include "jounce/profiles/vibration/shaper.hpp"

#include "support/random.hpp"

namespace jounce::vibration_band_test {
namespace {

constexpr double pi = std::numbers::pi;

Trajectory inclined_sine() {
  Segment f;
  f.degree = 1;
  f.c[1] = 1;
  f.sines = 1;
  f.sine[0] = {-1 / (2 * pi), 2 * pi, 0};
  return Trajectory({f});
}

double worst_of_grid(const Trajectory& f, const ModeBand& band, int n) {
  double worst = 0;
  for (int i = 0; i <= n; ++i)
    for (int j = 0; j <= n; ++j)
      worst = std::max(worst,
                       residual_vibration(
                           f, {band.low + (band.high - band.low) * i / n,
                               band.damping_low + (band.damping_high - band.damping_low) * j / n}));
  return worst;
}

TEST(WorstResidual, OfABandIsThatOfTheClosedForm) {
  // Undamped: 8 pi^2 |sin(W/2)| / (W |4 pi^2 - W^2|). Between W = 14 and 17 the largest value lies
  // inside the band.
  const auto closed = [](double w) {
    return 8 * pi * pi * std::abs(std::sin(w / 2)) / (w * std::abs(4 * pi * pi - w * w));
  };
  double best = 0;
  for (double w = 14; w <= 17; w += 1e-5) best = std::max(best, closed(w));
  const WorstMode worst =
      worst_residual(inclined_sine(), {14 / (2 * pi), 17 / (2 * pi), 0, 0}, 1e-9);
  EXPECT_NEAR(worst.residual, best, 2e-9);
  EXPECT_GT(worst.residual, closed(14));
  EXPECT_GT(worst.residual, closed(17));
  EXPECT_EQ(worst.mode.damping, 0);
}

/// The answer is attained, and no mode of a dense grid over frequency and damping is worse, the
/// inside of the band included, where the search never looks.
TEST(WorstResidual, IsNotExceededAnywhereInTheBand) {
  test::Random random(11);
  for (int n = 0; n < 30; ++n) {
    const Trajectory motion = s_curve({.to = random.uniform(0.5, 3),
                                       .velocity = random.uniform(0.5, 3),
                                       .acceleration = random.uniform(2, 20),
                                       .jerk = random.uniform(20, 400)})
                                  .curve();
    const double low = random.log_uniform(0.2, 8);
    const double damping = random.uniform(0, 0.6);
    const ModeBand band{low, low * random.uniform(1, 3), damping,
                        damping + random.uniform(0, 0.39)};
    SCOPED_TRACE(::testing::Message()
                 << "case " << n << ": " << band.low << " .. " << band.high << " Hz, damping "
                 << band.damping_low << " .. " << band.damping_high);
    const WorstMode worst = worst_residual(motion, band);
    EXPECT_EQ(worst.residual, residual_vibration(motion, worst.mode));
    const double travel = std::abs(value(motion.segments().back(), 1));
    const double seen = worst_of_grid(motion, band, 60);
    EXPECT_LE(seen, worst.residual + 1e-6 * travel);
    EXPECT_LE(worst.residual, seen * 1.01 + 1e-3 * travel);
    EXPECT_GE(worst.mode.frequency, band.low * (1 - 1e-12));
    EXPECT_LE(worst.mode.frequency, band.high * (1 + 1e-12));
    EXPECT_GE(worst.mode.damping, band.damping_low - 1e-12);
    EXPECT_LE(worst.mode.damping, band.damping_high + 1e-12);
  }
}

TEST(WorstResidual, CanBeAtTheGreatestDamping) {
  // A shaper for an undamped mode leaves more, the more it is damped.
  const Trajectory quiet = shaped(inclined_sine(), shaper({ShaperKind::zv, {2.5, 0}}));
  const WorstMode worst = worst_residual(quiet, {2.5, 2.5, 0, 0.2});
  EXPECT_GT(worst.mode.damping, 0.05);
  EXPECT_GT(worst.residual, residual_vibration(quiet, {2.5, 0}));
}

TEST(WorstResidual, RejectsABandOutOfRange) {
  const Trajectory f = inclined_sine();
  for (const ModeBand band :
       {ModeBand{0, 1}, ModeBand{2, 1}, ModeBand{1, NAN}, ModeBand{1, 2, -0.1, 0},
        ModeBand{1, 2, 0.2, 0.1}, ModeBand{1, 2, 0, 1}, ModeBand{1, INFINITY}})
    EXPECT_THROW((void)worst_residual(f, band), InputError) << band.low;
  EXPECT_THROW((void)worst_residual(f, {1, 2}, 0), InputError);
  EXPECT_THROW((void)worst_residual(f, {1, 2}, NAN), InputError);
}

}  // namespace
}  // namespace jounce::vibration_band_test
