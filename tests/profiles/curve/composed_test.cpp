// SPDX-License-Identifier: Apache-2.0
#include "jounce/profiles/curve/composed.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "jounce/profiles/curve/over_length.hpp"
#include "jounce/profiles/error.hpp"
#include "jounce/profiles/moves/s_curve.hpp"

#include "support/invariants.hpp"
#include "support/random.hpp"

namespace jounce::composed_test {
namespace {

/// The chain rule at a point, written out: what the composed curve must give.
Jet chained(const Jet& f, const Jet& x) {
  return {f[0], f[1] * x[1], f[2] * x[1] * x[1] + f[1] * x[2],
          f[3] * x[1] * x[1] * x[1] + 3 * f[2] * x[1] * x[2] + f[1] * x[3]};
}

/// Pointwise, away from breaks of the result (there the two may take different sides).
template <class Outer, class Inner>
void expect_chain_rule(const Curve<Outer>& outer, const Curve<Inner>& inner) {
  const auto g = composed(outer, inner);
  const Ranges ranges = extrema(g);
  EXPECT_NEAR(g.length(), inner.length(), 1e-14 * inner.length());
  for (std::size_t i = 0; i < g.segments().size(); ++i)
    for (int n = 1; n < 16; ++n) {
      const double x = g.breaks()[i] + g.segments()[i].length * n / 16;
      const Jet at = inner.jet(x);
      const Jet wanted = chained(outer.jet(at[0]), at);
      const Jet got = g.jet(x);
      for (std::size_t k = 0; k < 4; ++k) {
        const double scale = std::max(std::abs(ranges[k].min.value), std::abs(ranges[k].max.value));
        EXPECT_NEAR(got[k], wanted[k], 1e-11 * scale) << "derivative " << k << " at " << x;
      }
    }
}

Trajectory move() {
  return s_curve({.to = 50, .velocity = 10, .acceleration = 20, .jerk = 100}).curve();
}

Segment sine_rise(double length, double height) {  // the cycloid
  const double two_pi = 2 * std::acos(-1.0);
  Segment f = line(length, 0, height);
  f.sines = 1;
  f.sine[0] = {-height / two_pi, two_pi, 0};
  return f;
}

TEST(Composed, HalfSpeedIsTheMotionStretched) {
  const Trajectory f = move();
  const Trajectory g = composed(f, Trajectory({line(2 * f.end(), 0, f.end())}));
  const Trajectory expected = scaled(f, 1, 2);
  ASSERT_EQ(g.segments().size(), f.segments().size());
  for (std::size_t i = 0; i < g.segments().size(); ++i)
    for (std::size_t k = 0; k < 4; ++k)
      EXPECT_NEAR(g.segments()[i].c[k], expected.segments()[i].c[k], 1e-13 * 50);
}

TEST(Composed, KeepsTheChainRuleAlongAJerkLimitedClock) {
  const Trajectory clock =
      s_curve({.to = 5.7, .velocity = 1.1, .acceleration = 0.7, .jerk = 0.9}).curve();
  expect_chain_rule(move(), clock);
  test::expect_invariants(composed(move(), clock), 2);
}

TEST(Composed, StandsWhereTheClockStandsAndRunsBackWithIt) {
  const Trajectory there({line(3, 0, 3), line(1, 3, 3), line(2, 3, 0.5)});
  expect_chain_rule(move(), there);
  EXPECT_EQ(composed(move(), there).at(3.5).velocity, 0);
}

TEST(Composed, PlaysACamBehindAMaster) {
  const Cam poly5(
      {quintic(90, 0, 0, 0, 40, 0, 0), line(30, 40, 40), quintic(60, 40, 0, 0, 0, 0, 0)}, 0,
      Extrapolation::wrap);
  const Trajectory master =
      trapezoid({.from = 30, .to = 700, .velocity = 200, .acceleration = 400}).curve();
  expect_chain_rule(poly5, master);
  EXPECT_GT(composed(poly5, master).segments().size(), 12U) << "four turns and a master's ramps";
  test::expect_invariants(composed(poly5, master), 1);
}

TEST(Composed, TakesSinesBehindALinearMasterAndAheadOfALinearCam) {
  const Cam cycloid({sine_rise(100, 20), sine_rise(50, -20)}, 0, Extrapolation::hold);
  expect_chain_rule(cycloid, Trajectory({line(3, -20, 170)}));
  expect_chain_rule(Cam({line(7, 1, 2), line(3, 2, 0)}), Trajectory({sine_rise(2, 10)}));
}

TEST(Composed, AShortSegmentFarFromTheOriginEndsAtItsOwnEnd) {
  // Jerk phases of 4 ms, 10 000 s from the origin, where a double resolves 2e-12 s.
  const Trajectory f =
      shifted(s_curve({.to = 170, .velocity = 1.3, .acceleration = 0.14, .jerk = 35}).curve(), 1e4);
  const Trajectory clock({line(3 * f.length(), f.start(), f.end())}, 7e3);
  EXPECT_NEAR(extrema(composed(f, clock), 2).max.value, 0.14 / 9, 1e-14);
  EXPECT_NEAR(extrema(composed(f, clock), 2).min.value, -0.14 / 9, 1e-14);
}

TEST(Composed, AShortRampOnAnArcIsExactToItsOwnRounding) {
  // A ramp of 10 us covers 1e-10 of an arc with coordinates of 50: by differences of its ends,
  // rounding of the positions changed the jerk by 1e-4 of it.
  const double radius = 50;
  const double length = 2;
  Segment f = line(length, 0, 0);
  f.degree = 0;
  f.sines = 1;
  f.sine[0] = {radius, length / radius, 0.7};
  const Curve<OverLength> arc({f});
  for (const double v : {0.0, 1e-3, 2.0})
    for (const double duration : {1e-6, 1e-5, 1e-3}) {
      const double jerk = 6e5;
      Segment ramp;
      ramp.length = duration;
      ramp.degree = 3;
      ramp.c[0] = 0.3;
      ramp.c[1] = v * duration;
      ramp.c[3] = jerk * duration * duration * duration / 6;
      const Fitted<OverTime> g = composed_within(arc, Trajectory({ramp}), 1e-9);
      ASSERT_EQ(g.curve.segments().size(), 1U);
      for (int n = 0; n <= 16; ++n) {
        const double t = duration * n / 16;
        const Jet law{0.3 + t * (v + jerk * t * t / 6), v + jerk * t * t / 2, jerk * t, jerk};
        const double at = law[0] / radius + 0.7;
        const Jet place{radius * std::sin(at), std::cos(at), -std::sin(at) / radius,
                        -std::cos(at) / (radius * radius)};
        const Jet wanted = chained(place, law);
        const Jet got = evaluate(g.curve.segments()[0], n / 16.0);
        EXPECT_NEAR(got[0], wanted[0], 1e-13 * radius);
        EXPECT_NEAR(got[1], wanted[1], 1e-12 * law[1]) << v << ", " << duration << " at " << t;
        EXPECT_NEAR(got[3], wanted[3], 1e-11 * jerk) << v << ", " << duration << " at " << t;
        EXPECT_LE(g.error[3], 1e-10 * jerk);
      }
    }
}

TEST(Composed, RandomPolynomialsMeetTheChainRule) {
  test::Random random(7);
  for (int n = 0; n < 300 && !::testing::Test::HasFailure(); ++n) {
    SCOPED_TRACE(n);
    const auto polynomial = [&](int degree, double length) {
      Segment f;
      f.length = length;
      f.degree = degree;
      for (std::size_t k = 0; k <= static_cast<std::size_t>(degree); ++k)
        f.c[k] = random.uniform(-1, 1);
      return f;
    };
    const int outer_degree = 1 + random.below(5);
    const int inner_degree = 1 + random.below(11 / outer_degree);
    std::vector<Segment> pieces(6);
    for (Segment& f : pieces) f = polynomial(outer_degree, random.uniform(0.1, 2));
    const Trajectory outer(pieces, random.uniform(-4, -2), Extrapolation::wrap);
    const Trajectory inner({polynomial(inner_degree, 1.5), polynomial(inner_degree, 0.5)}, 1000);
    const Trajectory g = composed(outer, inner);
    for (std::size_t i = 0; i < g.segments().size(); ++i)
      for (const double s : {0.25, 0.5, 0.75}) {
        const double x = g.breaks()[i] + s * g.segments()[i].length;
        const double expected = outer.jet(inner.jet(x)[0])[0];
        EXPECT_NEAR(g.jet(x)[0], expected, 2e-11) << "at " << x;
      }
  }
}

TEST(Composed, RejectsContradictions) {
  const Trajectory quintic_move({quintic(1, 0, 0, 0, 1, 0, 0)});
  EXPECT_THROW(composed(quintic_move, Trajectory({cubic(2, 0, 0, 1, 0)})), InputError);
  EXPECT_THROW(composed(Cam({sine_rise(1, 1)}), Trajectory({cubic(2, 0, 0, 1, 0)})), InputError);
  EXPECT_THROW(composed(quintic_move, Trajectory({line(1, 0, 1.01)})), InputError)
      << "leaves a curve that refuses";
  EXPECT_NO_THROW(
      composed(with(quintic_move, Extrapolation::hold), Trajectory({line(1, -1, 1.01)})));
}

TEST(Composed, EndsWhereTheInnerEnds) {
  const Trajectory move =
      s_curve({.to = 50, .velocity = 10, .acceleration = 20, .jerk = 100}).curve();
  test::Random random(5);
  for (int i = 0; i < 2000; ++i) {
    const double length = i == 0 ? 1 : random.log_uniform(1e-3, 1e3);
    const double start = i < 1000 ? 0 : random.uniform(0, 1) * length;
    const double to = i == 0 ? move.end() : random.uniform(0.1, 1) * move.end();
    const Trajectory clock({line(length, 0, to)}, start);
    ASSERT_EQ(composed(move, clock).end(), clock.end())
        << "start " << start << " length " << length << " to " << to;
  }
}

TEST(Composed, RejectsMoreTurnsThanItCanHold) {
  const Trajectory turn({line(1, 0, 1), line(1, 1, 0)}, 0, Extrapolation::wrap);
  EXPECT_THROW(composed(turn, Trajectory({line(1, 0, 1e9)})), InputError);
}

}  // namespace
}  // namespace jounce::composed_test
