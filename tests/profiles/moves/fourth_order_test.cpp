// SPDX-License-Identifier: Apache-2.0
#include "jounce/profiles/moves/fourth_order.hpp"

#include <cmath>
#include <fstream>
#include <limits>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "jounce/profiles/curve/extrema.hpp"
#include "jounce/profiles/error.hpp"
#include "jounce/profiles/moves/s_curve.hpp"

#include "support/invariants.hpp"
#include "support/random.hpp"

namespace jounce::fourth_order_test {
namespace {

/// Ends, limits and joints, walked in long double along the jounces, independent of the values in
/// the segments.
void expect_move(const Trajectory& f, const FourthOrderSpec& s) {
  using Long = long double;
  std::array<Long, 4> x{static_cast<Long>(s.from)};
  const std::array<double, 4> limit{std::abs(s.to - s.from), s.velocity, s.acceleration, s.jerk};
  const double at_ends = std::max(std::abs(s.from), std::abs(s.to));
  for (const Segment& piece : f.segments()) {
    const Jet begin = evaluate(piece, 0);
    for (std::size_t k = 0; k < 4; ++k)
      EXPECT_NEAR(begin[k], static_cast<double>(x[k]),
                  1e-12 * limit[k] + (k == 0 ? 1e-15 * at_ends : 0))
          << "derivative " << k;
    for (std::size_t k = 1; k < 4; ++k)
      EXPECT_LE(std::abs(begin[k]), limit[k] * (1 + 1e-12)) << "derivative " << k;
    const Long t = piece.length;
    const Long u = 24 * static_cast<Long>(piece.c[4]) / (t * t * t * t);
    EXPECT_LE(std::abs(static_cast<double>(u)), s.jounce * (1 + 1e-12));
    x = {x[0] + t * (x[1] + t * (x[2] / 2 + t * (x[3] / 6 + t * u / 24))),
         x[1] + t * (x[2] + t * (x[3] / 2 + t * u / 6)), x[2] + t * (x[3] + t * u / 2),
         x[3] + t * u};
    for (std::size_t k = 1; k < 4; ++k)
      EXPECT_LE(std::abs(static_cast<double>(x[k])), limit[k] * (1 + 1e-12)) << "derivative " << k;
  }
  EXPECT_NEAR(static_cast<double>(x[0]), s.to, 1e-12 * limit[0] + 1e-15 * at_ends);
  for (std::size_t k = 1; k < 4; ++k) EXPECT_NEAR(static_cast<double>(x[k]), 0, 1e-12 * limit[k]);
}

TEST(FourthOrder, JounceAloneIsThePerfectSpline) {
  // The least peak of the 4th derivative of a rest-to-rest move over 1 in T = 1 is 384, with switches
  // at sin^2(i pi/8).
  const Trajectory f =
      fourth_order({.to = 1, .velocity = 1e3, .acceleration = 1e3, .jerk = 1e3, .jounce = 384});
  EXPECT_DOUBLE_EQ(f.length(), 1);
  EXPECT_DOUBLE_EQ(f.at(std::pow(std::sin(std::acos(-1.0) / 8), 2)).jerk,
                   f.at(0.5).jerk / -std::sqrt(2.0));
}

TEST(FourthOrder, LambrechtsFifteenPhases) {
  // All limits are reached: T = h/v + v/a + a/j + j/s, and phases of j/s, a/j - j/s, v/a - a/j -
  // j/s.
  const Trajectory f =
      fourth_order({.to = 1, .velocity = 0.9, .acceleration = 4, .jerk = 40, .jounce = 1000});
  ASSERT_EQ(f.segments().size(), 15U);
  EXPECT_NEAR(f.length(), 1 / 0.9 + 0.9 / 4 + 4.0 / 40 + 40.0 / 1000, 1e-15);
  EXPECT_DOUBLE_EQ(f.segments()[0].length, 0.04);
  EXPECT_NEAR(f.segments()[1].length, 0.06, 1e-16);
  EXPECT_NEAR(f.segments()[3].length, 0.085, 1e-15);
}

TEST(FourthOrder, IsAsFastAsLinearProgrammingFinds) {
  const auto cases =
      nlohmann::json::parse(std::ifstream(JOUNCE_SOURCE_DIR "/tests/oracle/fourth_order.json"));
  for (const auto& c : cases) {
    SCOPED_TRACE(c["name"].get<std::string>());
    const FourthOrderSpec spec{0, 1, c["velocity"], c["acceleration"], c["jerk"], c["jounce"]};
    const Trajectory f = fourth_order(spec);
    const bool held = extrema(f, 1).max.value > 0.9999 * spec.velocity;
    const double least = c["duration"];
    EXPECT_GE(f.length(), least * (1 - 5e-5));
    EXPECT_LE(f.length(), least * (1 + (held ? 1e-3 : 5e-5)));
  }
}

TEST(FourthOrder, KeepsItsLimitsOverSixDecades) {
  test::Random random(31);
  for (int i = 0; i < 100000 && !::testing::Test::HasFailure(); ++i) {
    FourthOrderSpec s;
    s.from = random.uniform(-1, 1);
    s.to = s.from + (random.below(2) == 0 ? 1 : -1) * random.log_uniform(1e-3, 1e3);
    s.velocity = random.log_uniform(1e-3, 1e3);
    s.acceleration = random.log_uniform(1e-3, 1e3);
    s.jerk = random.log_uniform(1e-3, 1e3);
    s.jounce = random.log_uniform(1e-3, 1e3);
    SCOPED_TRACE(::testing::Message() << i << ": " << s.from << ' ' << s.to << ' ' << s.velocity
                                      << ' ' << s.acceleration << ' ' << s.jerk << ' ' << s.jounce);
    const Trajectory f = fourth_order(s);
    expect_move(f, s);
    if (i % 100 == 0) test::expect_invariants(f, 3);
  }
}

TEST(FourthOrder, AShortCruiseFarFromZeroKeepsItsVelocity) {
  // It takes 56 us over 9e-7, and positions of 12 are known to 2e-15.
  const FourthOrderSpec s{.from = -12.148613687577097,
                          .to = -12.160227512763784,
                          .velocity = 0.015339426505995825,
                          .acceleration = 0.87862371166295539,
                          .jerk = 0.10916184093555698,
                          .jounce = 14.932011939987934};
  expect_move(fourth_order(s), s);
  test::Random random(33);
  for (int i = 0; i < 20000 && !::testing::Test::HasFailure(); ++i) {
    FourthOrderSpec far;
    far.from = random.uniform(-1, 1) * random.log_uniform(1, 1e4);
    far.to = far.from + (random.below(2) == 0 ? 1 : -1) * random.log_uniform(1e-2, 1);
    far.acceleration = random.log_uniform(0.1, 10);
    far.jerk = random.log_uniform(0.1, 100);
    far.jounce = random.log_uniform(1, 1000);
    far.velocity = 1e3;
    // Just below what it reaches unlimited: a cruise, if any, is short.
    const double peak = std::abs(extrema(fourth_order(far), 1).peak().value);
    far.velocity = peak * random.uniform(0.5, 1);
    SCOPED_TRACE(::testing::Message()
                 << i << ": " << number(far.from) << ' ' << number(far.to) << ' '
                 << number(far.velocity) << ' ' << number(far.acceleration) << ' '
                 << number(far.jerk) << ' ' << number(far.jounce));
    expect_move(fourth_order(far), far);
  }
}

TEST(FourthOrder, GrowsContinuouslyThroughItsRegimes) {
  // From a touch of the velocity limit to a cruise: a little more way takes a little more time, and
  // a higher limit never takes longer.
  double before = 0;
  for (int i = 0; i <= 4000; ++i) {
    const double v = 3 - 2.5 * i / 4000;
    const double t =
        fourth_order({.to = 1, .velocity = v, .acceleration = 9, .jerk = 50, .jounce = 384})
            .length();
    if (before > 0) {
      EXPECT_GE(t, before * (1 - 1e-14)) << v;
      EXPECT_LE(t, before * 1.01) << v;
    }
    before = t;
  }
}

TEST(FourthOrder, TendsToTheSCurve) {
  test::Random random(32);
  for (int i = 0; i < 1000; ++i) {
    SCurveSpec s{.to = random.log_uniform(1e-2, 1e2)};
    s.velocity = random.log_uniform(1e-2, 1e2);
    s.acceleration = random.log_uniform(1e-2, 1e2);
    s.jerk = random.log_uniform(1e-2, 1e2);
    const double third = s_curve(s).duration();
    const double jounce = 1e8 * s.jerk / third;
    const double fourth =
        fourth_order({0, s.to, s.velocity, s.acceleration, s.jerk, jounce}).length();
    EXPECT_GE(fourth, third * (1 - 1e-14));
    EXPECT_LE(fourth, third * (1 + 4e-8)) << i;  // at most four ramps of j/s more
  }
}

TEST(FourthOrder, DoesNotDependOnTheUnit) {
  for (const double v : {0.2, 1.7, 1.9, 100.0})
    for (const double k : {0x1p-20, 0x1p20}) {
      const FourthOrderSpec meters{0, 1, v, 9, 50, 384};
      const FourthOrderSpec other{0, k, v * k, 9 * k, 50 * k, 384 * k};
      EXPECT_EQ(fourth_order(meters).length(), fourth_order(other).length()) << v;
    }
}

TEST(FourthOrder, RejectsAnInvalidMove) {
  const FourthOrderSpec good{0, 1, 1, 1, 1, 1};
  const double nan = std::nan("");
  for (double FourthOrderSpec::*key : {&FourthOrderSpec::velocity, &FourthOrderSpec::acceleration,
                                       &FourthOrderSpec::jerk, &FourthOrderSpec::jounce})
    for (const double bad : {0.0, -1.0, nan, std::numeric_limits<double>::infinity()}) {
      FourthOrderSpec spec = good;
      spec.*key = bad;
      EXPECT_THROW(fourth_order(spec), InputError);
    }
  EXPECT_THROW(fourth_order({1, 1, 1, 1, 1, 1}), InputError);
  EXPECT_THROW(fourth_order({0, 1, 1, 1, 1, 1e20}), InputError);
}

}  // namespace
}  // namespace jounce::fourth_order_test
