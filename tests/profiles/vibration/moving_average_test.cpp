// SPDX-License-Identifier: Apache-2.0
#include "jounce/profiles/vibration/moving_average.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "jounce/profiles/curve/between.hpp"
#include "jounce/profiles/error.hpp"
#include "jounce/profiles/moves/s_curve.hpp"

#include "support/invariants.hpp"
#include "support/random.hpp"

namespace jounce::moving_average_test {
namespace {

void expect_equal(const Trajectory& f, const Trajectory& g, double rounding) {
  ASSERT_EQ(f.segments().size(), g.segments().size());
  const Ranges ranges = extrema(g);
  for (std::size_t i = 0; i < f.segments().size(); ++i) {
    EXPECT_NEAR(f.segments()[i].length, g.segments()[i].length, rounding * g.length());
    for (int n = 0; n <= 8; ++n) {
      const Jet a = evaluate(f.segments()[i], n / 8.0);
      const Jet b = evaluate(g.segments()[i], n / 8.0);
      for (std::size_t k = 0; k < 4; ++k)
        EXPECT_NEAR(a[k], b[k], rounding * std::abs(ranges[k].peak().value))
            << "derivative " << k << " in segment " << i;
    }
  }
}

/// Gauss-Legendre with five points on every piece between breaks: exact for the degrees used here.
double mean_by_quadrature(const Trajectory& f, double from, double to) {
  constexpr std::array x{0.0, 0.5384693101056831, 0.9061798459386640};
  constexpr std::array w{0.5688888888888889, 0.4786286704993665, 0.2369268850561891};
  std::vector<double> ends{from};
  for (const double b : f.breaks())
    if (b > from && b < to) ends.push_back(b);
  ends.push_back(to);
  double total = 0;
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
    const double m = (ends[i] + ends[i + 1]) / 2;
    const double h = (ends[i + 1] - ends[i]) / 2;
    total += h * w[0] * f.at(m).position;
    for (std::size_t k = 1; k < 3; ++k)
      total += h * w[k] * (f.at(m - h * x[k]).position + f.at(m + h * x[k]).position);
  }
  return total / (to - from);
}

Trajectory himc_trapezoid() {
  return trapezoid({.to = 1000, .velocity = 100, .acceleration = 500}).curve();
}

TEST(MovingAverage, OfATrapezoidIsTheSCurve) {
  // HIMC HMPL manual 5.1: v 100, a 500, Ts 50 ms: jerk 10000, each ramp 200 + 50 = 250 ms.
  const Trajectory smooth = moving_average(himc_trapezoid(), 0.05);
  const Trajectory expected =
      s_curve({.to = 1000, .velocity = 100, .acceleration = 500, .jerk = 10000}).curve();
  expect_equal(smooth, expected, 1e-12);
  EXPECT_NEAR(smooth.breaks()[3], 0.25, 1e-15);
  EXPECT_NEAR(smooth.end(), himc_trapezoid().end() + 0.05, 1e-13);
}

TEST(MovingAverage, OfAnAsymmetricTrapezoidIsTheSCurveOfTwoJerks) {
  // Googol iDEABOX Pro manual 7.2, example 7-1.
  const Trajectory f =
      trapezoid({.to = 50000, .velocity = 50, .acceleration = 0.25, .deceleration = 0.125}).curve();
  const Trajectory expected = s_curve({.to = 50000,
                                       .velocity = 50,
                                       .acceleration = 0.25,
                                       .deceleration = 0.125,
                                       .jerk = 0.25 / 25,
                                       .deceleration_jerk = 0.125 / 25})
                                  .curve();
  expect_equal(moving_average(f, 25), expected, 1e-12);
}

TEST(MovingAverage, MeetsAQuadratureOfTheDefinition) {
  const Trajectory f =
      s_curve({.from = 4, .to = 9, .velocity = 3, .acceleration = 20, .jerk = 300}).curve();
  for (const double window : {0.01, 0.3, f.length(), 3 * f.length()}) {
    SCOPED_TRACE(window);
    const Trajectory g = moving_average(f, window);
    const Trajectory held = with(f, Extrapolation::hold);
    for (int i = 0; i <= 100; ++i) {
      const double t = g.start() + g.length() * i / 100;
      EXPECT_NEAR(g.at(t).position, mean_by_quadrature(held, t - window, t), 1e-13) << t;
    }
    test::expect_invariants(g, 3);
  }
}

TEST(MovingAverage, EachApplicationIsOneOrderSmoother) {
  Trajectory f = himc_trapezoid();
  for (int order = 2; order <= 4; ++order) {
    f = moving_average(f, 0.03 * order);
    for (int k = 0; k <= std::min(order, 3); ++k) {
      const Range range = extrema(f, k);
      EXPECT_NEAR(largest_jump(f, k).step, 0, 1e-11 * std::abs(range.peak().value)) << k;
    }
  }
  EXPECT_EQ(f.segments().front().degree, 5);
  EXPECT_NEAR(f.at(f.end()).position, 1000, 1e-12 * 1000);
}

TEST(MovingAverage, SinesStaySinesOfTheirFrequency) {
  const double two_pi = 2 * std::acos(-1.0);
  Segment f = line(2, 0, 10);
  f.sines = 1;
  f.sine[0] = {-10 / two_pi, two_pi, 0};
  const Trajectory g = moving_average(Trajectory({f}), 0.5);
  // A window that lies inside: the mean of the line and of the sine in closed form.
  const double w = two_pi / 2;
  for (const double t : {0.6, 1.0, 1.7}) {
    const double line_mean = 5 * (t - 0.25);
    const double sine_mean = -10 / two_pi * (std::cos(w * (t - 0.5)) - std::cos(w * t)) / (w * 0.5);
    EXPECT_NEAR(g.at(t).position, line_mean + sine_mean, 1e-14 * 10);
  }
  EXPECT_EQ(g.segments()[1].sines, 1) << "the difference of two sines of one frequency";
  test::expect_invariants(g, 2);
}

TEST(MovingAverage, PassesTheSeamOfACurveThatWraps) {
  const Trajectory f({line(1, 0, 1), line(2, 1, 0)}, 5, Extrapolation::wrap);
  const Trajectory g = moving_average(f, 0.5);
  EXPECT_EQ(g.start(), 5);
  EXPECT_NEAR(g.end(), 8, 1e-15);
  EXPECT_NEAR(g.at(5).position, 0.125, 1e-15) << "half a second at -1/2 per second";
  EXPECT_NEAR(g.at(8, Side::left).position, 0.125, 1e-15);
  EXPECT_NEAR(extrema(moving_average(f, 3), 0).max.value, 0.5, 1e-15) << "a whole turn: the mean";
  EXPECT_NEAR(extrema(moving_average(f, 3), 0).min.value, 0.5, 1e-15);
  EXPECT_TRUE(check_continuity(g, 1).ok());
}

TEST(MovingAverage, AFarOriginCostsNoDigits) {
  const Trajectory near = moving_average(himc_trapezoid(), 0.05);
  const Trajectory far = moving_average(shifted(himc_trapezoid(), 0, 0x1p30), 0.05);
  EXPECT_NEAR(extrema(far, 3).max.value, 10000, 1e-2 /* 2^30 has an ulp of 2e-7 */);
  EXPECT_NEAR(extrema(near, 3).max.value, 10000, 1e-9);
}

TEST(MovingAverage, KeepsItsPromisesOverFiveDecadesOfWindows) {
  test::Random random(77);
  for (int n = 0; n < 300 && !HasFailure(); ++n) {
    const double v = random.log_uniform(0.01, 1000);
    const double a = v / random.log_uniform(0.01, 10);
    const double j = a / random.log_uniform(0.001, 3);
    const double to = random.log_uniform(0.01, 20) * (v * v / a + v * a / j);
    const Trajectory move = s_curve({0, to, v, a, 0, j, 0}).curve();
    const Trajectory f = shifted(move, random.uniform(-100, 100) * move.length());
    // Half of the windows coincide with the distance of two breaks.
    const int breaks = static_cast<int>(f.breaks().size());
    const double window =
        random.below(2) == 0
            ? random.log_uniform(1e-4, 3) * f.length()
            : move.breaks()[1 + static_cast<std::size_t>(random.below(breaks - 1))];
    SCOPED_TRACE(::testing::Message() << "to " << to << " v " << v << " a " << a << " j " << j
                                      << " start " << f.start() << " window " << window);
    const Trajectory g = moving_average(f, window);
    EXPECT_TRUE(check_continuity(g, 2).ok());
    EXPECT_NEAR(g.at(g.end()).position, to, 2e-14 * to);
    for (int k = 1; k < 3; ++k)
      EXPECT_LE(std::abs(extrema(g, k).peak().value),
                std::abs(extrema(f, k).peak().value) * (1 + 1e-9));
  }
}

TEST(MovingAverage, AtItsShortestWindowNoPeakGrows) {
  for (const Trajectory& f :
       {s_curve({.to = 50, .velocity = 10, .acceleration = 20, .jerk = 100}).curve(),
        trapezoid({.to = 50, .velocity = 10, .acceleration = 20}).curve()}) {
    const double window = 1e-5 * f.length();
    const Trajectory g = moving_average(f, window);
    EXPECT_TRUE(check_continuity(g, 1).ok());
    for (int k = 1; k < 3; ++k)
      EXPECT_LE(std::abs(extrema(g, k).peak().value),
                std::abs(extrema(f, k).peak().value) * (1 + 1e-6));
  }
}

TEST(MovingAverage, RejectsAWindowWithoutDigits) {
  const Trajectory f = s_curve({.to = 50, .velocity = 10, .acceleration = 20, .jerk = 100}).curve();
  for (const double window : {1e-14, 1e-12, 1e-9, 5e-5, 1e5})
    EXPECT_THROW(moving_average(f, window), InputError) << window;
  EXPECT_THROW(moving_average(scaled(f, 1, 1e8), 1e-4), InputError);
  EXPECT_THROW(moving_average(with(f, Extrapolation::wrap), 1e9), InputError);
}

TEST(MovingAverage, RejectsAMovingEnd) {
  const Trajectory f = s_curve({.to = 50, .velocity = 10, .acceleration = 20, .jerk = 100}).curve();
  EXPECT_THROW(moving_average(between(f, 0, 3), 0.1), InputError);
  EXPECT_THROW(moving_average(between(f, 3, f.end()), 0.1), InputError);
  const Trajectory jog = with(between(f, 1, 3), Extrapolation::wrap);
  EXPECT_NO_THROW(moving_average(jog, 0.1)) << "it never ends";
}

TEST(MovingAverage, RejectsWhatItCannotHold) {
  EXPECT_THROW(moving_average(himc_trapezoid(), 0), InputError);
  EXPECT_THROW(moving_average(himc_trapezoid(), -1), InputError);
  Segment full;
  full.degree = 11;
  full.c[11] = 1;
  EXPECT_THROW(moving_average(Trajectory({full}), 0.1), InputError);
}

}  // namespace
}  // namespace jounce::moving_average_test
