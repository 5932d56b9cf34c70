// SPDX-License-Identifier: Apache-2.0
#include "jounce/profiles/curve/fitted.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "jounce/profiles/curve/composed.hpp"
#include "jounce/profiles/curve/extrema.hpp"
#include "jounce/profiles/detail/hermite.hpp"
#include "jounce/profiles/error.hpp"
#include "jounce/profiles/limits/limits.hpp"

#include "support/random.hpp"

namespace jounce::fitted_test {
namespace {

constexpr double pi = std::numbers::pi;

Segment random_segment(test::Random& random, int degree, int sines, double length) {
  Segment f;
  f.length = length;
  f.degree = degree;
  f.sines = sines;
  for (std::size_t k = 0; k <= static_cast<std::size_t>(degree); ++k)
    f.c[k] = random.uniform(-1, 1);
  for (std::size_t i = 0; i < static_cast<std::size_t>(sines); ++i)
    f.sine[i] = {random.uniform(-1, 1), random.log_uniform(0.1, 30), random.uniform(-3, 3)};
  return f;
}

TEST(Hermite, OfDegreeElevenReproducesIt) {
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    SCOPED_TRACE(seed);
    test::Random random(seed);
    const Segment f = random_segment(random, 11, 0, random.log_uniform(1e-9, 1e9));
    const Segment g = profiles_detail::hermite(f.length, profiles_detail::taylor(f, 0),
                                               profiles_detail::taylor(f, 1));
    for (std::size_t k = 0; k < f.c.size(); ++k) EXPECT_NEAR(g.c[k], f.c[k], 1e-9) << k;
  }
}

TEST(Hermite, ErrorIsReachedByThePowerTwelve) {
  // h = s^12: h^(12)/12! = 1, and the error is s^6 (1 - s)^6 itself: the bound is its peak.
  profiles_detail::EndSeries at1{1, 12, 66, 220, 495, 792};
  const Segment f = profiles_detail::hermite(1, {}, at1);
  const double error = std::pow(0.5, 12) - value(f, 0.5);
  EXPECT_NEAR(profiles_detail::hermite_error(1, 1)[0], error, 1e-12);
  for (int n = 1; n < 100; ++n) {
    const double s = n / 100.0;
    const Jet g = evaluate(f, s);
    const Jet h{std::pow(s, 12), 12 * std::pow(s, 11), 132 * std::pow(s, 10),
                1320 * std::pow(s, 9)};
    for (std::size_t k = 0; k < 4; ++k)
      EXPECT_LE(std::abs(g[k] - h[k]), profiles_detail::hermite_error(1, 1)[k] + 1e-11) << k;
  }
}

TEST(Fitted, PolynomialsStayWithinTheCertifiedError) {
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    SCOPED_TRACE(seed);
    test::Random random(seed);
    const double unit = random.log_uniform(1e-9, 1e9);
    const Trajectory f({random_segment(random, random.below(12), 1 + random.below(3),
                                       random.log_uniform(1e-9, 1e9))});
    const Trajectory scaled_f = scaled(f, unit);
    const double tolerance = random.log_uniform(1e-11, 1e-2) * unit;
    const auto fitted = polynomial_within(scaled_f, tolerance);
    EXPECT_LE(fitted.error[0], tolerance);
    const Ranges ranges = extrema(scaled_f);
    for (const Segment& piece : fitted.curve.segments()) EXPECT_EQ(piece.sines, 0);
    for (int n = 0; n < 200; ++n) {
      const double x = random.uniform(0, f.length());
      const Jet wanted = scaled_f.jet(x);
      const Jet got = fitted.curve.jet(x);
      double rounding = 1e-13;
      for (std::size_t k = 0; k < 4; ++k, rounding *= 1000)
        EXPECT_NEAR(got[k], wanted[k],
                    fitted.error[k] + rounding * std::abs(ranges[k].peak().value))
            << k << " at " << x;
    }
    if (HasFailure()) break;
  }
}

TEST(Fitted, KeepsWhatHasNoSines) {
  const Trajectory f({quintic(2, 0, 0, 0, 1, 0, 0), line(1, 1, 1)});
  const auto fitted = polynomial_within(f, 1e-6);
  EXPECT_EQ(fitted.error, Jet{});
  ASSERT_EQ(fitted.curve.segments().size(), 2U);
  EXPECT_EQ(fitted.curve.segments()[0].c, f.segments()[0].c);
}

TEST(Fitted, RejectsAToleranceBelowRounding) {
  const Trajectory f({line(1, 0, 1000)});
  EXPECT_THROW(polynomial_within(f, 0), InputError);
  EXPECT_THROW(polynomial_within(f, -1), InputError);
  EXPECT_THROW(polynomial_within(f, 1e-12), InputError);
  EXPECT_NO_THROW(polynomial_within(f, 1e-10));
}

TEST(ComposedWithin, IsTheCompositionWhereThatFits) {
  const Trajectory f({quintic(1, 0, 0, 0, 1, 0, 0), line(1, 1, 1)});
  const Trajectory clock({cubic(3, 0, 0, 1.5, 0.5)});  // degree 15 on the first piece
  EXPECT_THROW(composed(f, clock), InputError);
  const auto fitted = composed_within(f, clock, 1e-9);
  EXPECT_GT(fitted.error[0], 0);
  EXPECT_EQ(fitted.curve.segments().back().degree, 0) << "behind the line it is exact";
  const Trajectory slower({line(3, 0, 2)});
  EXPECT_EQ(composed_within(f, slower, 1e-9).error, Jet{});
}

TEST(ComposedWithin, HoldsTheChainRuleWithinTheCertifiedError) {
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    SCOPED_TRACE(seed);
    test::Random random(seed);
    const Trajectory outer({random_segment(random, random.below(12), random.below(4), 1),
                            random_segment(random, random.below(6), random.below(3), 2)},
                           -1, Extrapolation::hold);
    const Trajectory inner({random_segment(random, 1 + random.below(6), random.below(3),
                                           random.log_uniform(0.1, 10))});
    const double tolerance = random.log_uniform(1e-10, 1e-3);
    const auto fitted = composed_within(outer, inner, tolerance);
    EXPECT_LE(fitted.error[0], tolerance);
    for (std::size_t i = 0; i < fitted.curve.segments().size(); ++i)
      for (int n = 1; n < 8; ++n) {
        const double x = fitted.curve.breaks()[i] + fitted.curve.segments()[i].length * n / 8;
        const Jet y = inner.jet(x);
        const Jet f = outer.jet(y[0]);
        const Jet chain{f[0], f[1] * y[1], f[2] * y[1] * y[1] + f[1] * y[2],
                        f[3] * y[1] * y[1] * y[1] + 3 * f[2] * y[1] * y[2] + f[1] * y[3]};
        const Jet got = fitted.curve.jet(x);
        double rounding = 1e-12;
        for (std::size_t k = 0; k < 4; ++k, rounding *= 30 / fitted.curve.segments()[i].length)
          EXPECT_NEAR(got[k], chain[k], fitted.error[k] + rounding * (1 + std::abs(chain[k])))
              << k << " at " << x;
      }
    if (HasFailure()) break;
  }
}

TEST(ComposedWithin, IsAsSmoothAsTheFunction) {
  Segment cycloid = line(1, 0, 1);
  cycloid.sines = 1;
  cycloid.sine[0] = {-1 / (2 * pi), 2 * pi, 0};
  const Trajectory f({cycloid});
  const auto twice = composed_within(f, f, 1e-8);
  EXPECT_GT(twice.curve.segments().size(), 1U);
  EXPECT_TRUE(check_continuity(twice.curve, 3, 1e-9).ok());
  EXPECT_NEAR(twice.curve.jet(0.5)[1], 4, 1e-7);
}

}  // namespace
}  // namespace jounce::fitted_test
