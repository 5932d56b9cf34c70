// SPDX-License-Identifier: Apache-2.0
#include "optimize/src/knots/bound.hpp"

#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "optimize/rest_to_rest.hpp"

namespace jounce::bound_test {
namespace {

using test_optimize::fig614;
using test_optimize::rest_to_rest;

/// A raw mt19937 word as a double in [lo, hi): portable, unlike the standard distributions.
double draw(std::mt19937& random, double lo, double hi) {
  return lo + (hi - lo) * (static_cast<double>(random()) * 0x1p-32);
}

/// End of a motion with piecewise constant `derivative` (acceleration or jerk).
struct End {
  double p = 0;
  double v = 0;
  double a = 0;
  void run(double jerk, double u) {
    p += u * (v + u * (a / 2 + u * jerk / 6));
    v += u * (a + u * jerk / 2);
    a += u * jerk;
  }
};

TEST(LeastPeakAcceleration, IsFourFromRestToRest) {
  EXPECT_DOUBLE_EQ(least_peak_acceleration({1, 1, 0, 0, {}, {}}), 4);
  EXPECT_DOUBLE_EQ(least_peak_acceleration({0.5, -3, 0, 0, {}, {}}), 4 * 3 / 0.25);
}

TEST(LeastPeakAcceleration, IsThatOfAParabolaForConstantAcceleration) {
  // v from 1 to 4 over 2: chord 5, one constant acceleration 1.5 does it.
  EXPECT_DOUBLE_EQ(least_peak_acceleration({2, 5, 1, 4, {}, {}}), 1.5);
  EXPECT_EQ(least_peak_acceleration({2, 6, 3, 3, {}, {}}), 0);
}

TEST(LeastPeakAcceleration, IsAttainedByBangCoastBang) {
  std::mt19937 random(1);
  for (int i = 0; i < 1000; ++i) {
    const double A = draw(random, 0.1, 5);
    const double t1 = draw(random, 0.1, 2);
    const double t2 = draw(random, 0.1, 2);
    const double coast = i % 2 == 0 ? 0 : draw(random, 0.1, 2);
    const double v0 = draw(random, -3, 3);
    const double sign = i % 3 == 0 ? -1 : 1;
    const double V = v0 + A * t1;
    const double v1 = V - A * t2;
    const double d = (v0 + V) / 2 * t1 + V * coast + (V + v1) / 2 * t2;
    // The cap counts for |v|: only cases where it is V itself that binds.
    if (coast > 0 && V < std::max(std::abs(v0), std::abs(v1))) continue;
    const KnotInterval s{t1 + coast + t2, sign * d, sign * v0, sign * v1, {}, {}};
    const auto cap = coast > 0 ? std::optional(V) : std::nullopt;
    EXPECT_NEAR(least_peak_acceleration(s, cap), A, 1e-11 * A) << i;
    const KnotInterval back{s.length, s.displacement, s.v1, s.v0, {}, {}};
    EXPECT_NEAR(least_peak_acceleration(back, cap), A, 1e-11 * A) << i;
  }
}

TEST(LeastPeakAcceleration, OfFig614NeedsTheVelocityLimit) {
  // 200..360: from slope 1 to rest by -225. Without limit A = (610 + sqrt(610^2 + 160^2)) / 160^2;
  // with |v| <= 3: A = ((3 + 1)^2 + 3^2) / (2 (3 * 160 - 225)) = 25 / 510.
  const KnotInterval s{160, -225, 1, 0, {}, {}};
  EXPECT_NEAR(least_peak_acceleration(s), (610 + std::hypot(610, 160)) / 25600, 1e-16);
  EXPECT_NEAR(least_peak_acceleration(s, 3), 25.0 / 510, 1e-16);
}

TEST(LeastPeakAcceleration, IsInfiniteWhereTheVelocityLimitCannotHold) {
  EXPECT_TRUE(std::isinf(least_peak_acceleration({1, 2, 0, 0, {}, {}}, 2)));
  EXPECT_TRUE(std::isinf(least_peak_acceleration({1, 1, 3, 0, {}, {}}, 2)));
  EXPECT_TRUE(std::isinf(least_peak_acceleration({1, -0.5, -3, 0, {}, {}}, 2)));
}

TEST(LeastPeakJerk, IsThirtyTwoFromRestToRest) {
  EXPECT_NEAR(least_peak_jerk({1, 1, 0, 0, 0, 0}), 32, 1e-13);
  EXPECT_NEAR(least_peak_jerk({0.5, -3, 0, 0, 0, 0}), 32 * 3 / 0.125, 1e-11);
  EXPECT_DOUBLE_EQ(least_peak_jerk({1, 1, 0, 0, {}, {}}), 12);  // the cubic
  EXPECT_EQ(least_peak_jerk({2, 6, 3, 3, 0, 0}), 0);
}

TEST(LeastPeakJerk, IsAttainedByEveryPerfectSpline) {
  std::mt19937 random(2);
  for (int i = 0; i < 2000; ++i) {
    const double J = draw(random, 0.1, 9) * (i % 2 == 0 ? 1 : -1);
    End end{0, draw(random, -3, 3), draw(random, -3, 3)};
    const End start = end;
    const double t1 = draw(random, 0.05, 1);
    const double t2 = draw(random, 0.05, 1);
    const double t3 = draw(random, 0.05, 1);
    end.run(J, t1);
    end.run(-J, t2);
    const KnotInterval one{t1 + t2, end.p, start.v, end.v, start.a, {}};
    EXPECT_NEAR(least_peak_jerk(one), std::abs(J), 1e-10 * std::abs(J)) << i;
    const KnotInterval one_back{t1 + t2, end.p, end.v, start.v, {}, -start.a};
    EXPECT_NEAR(least_peak_jerk(one_back), std::abs(J), 1e-10 * std::abs(J)) << i;
    end.run(J, t3);
    const KnotInterval two{t1 + t2 + t3, end.p, start.v, end.v, start.a, end.a};
    EXPECT_NEAR(least_peak_jerk(two), std::abs(J), 1e-9 * std::abs(J)) << i;
  }
}

TEST(LeastPeakJerk, GrowsWithWhatIsGiven) {
  std::mt19937 random(3);
  for (int i = 0; i < 500; ++i) {
    KnotInterval s{draw(random, 0.2, 3),
                   draw(random, -2, 2),
                   draw(random, -2, 2),
                   draw(random, -2, 2),
                   {},
                   {}};
    const double none = least_peak_jerk(s);
    s.a0 = draw(random, -4, 4);
    const double one = least_peak_jerk(s);
    s.a1 = draw(random, -4, 4);
    const double two = least_peak_jerk(s);
    EXPECT_LE(none, one * (1 + 1e-12));
    EXPECT_LE(one, two * (1 + 1e-12));
    const double peak =
        value_of(Objective::peak_jerk,
                 Cam({quintic(s.length, 0, s.v0, *s.a0, s.displacement, s.v1, *s.a1)}));
    EXPECT_LE(two, peak * (1 + 1e-12));
  }
}

TEST(LeastSquareAcceleration, IsTheCubics) {
  EXPECT_DOUBLE_EQ(least_square_acceleration({1, 1, 0, 0, {}, {}}), 12);
  std::mt19937 random(4);
  for (int i = 0; i < 200; ++i) {
    const KnotInterval s{draw(random, 0.2, 3),
                         draw(random, -2, 2),
                         draw(random, -2, 2),
                         draw(random, -2, 2),
                         {},
                         {}};
    const Cam cam({cubic(s.length, 0, s.v0, s.displacement, s.v1)});
    const double rms = value_of(Objective::rms_acceleration, cam);
    EXPECT_NEAR(least_square_acceleration(s), rms * rms * s.length, 1e-12 * (1 + rms * rms));
  }
}

TEST(LowerBound, TakesTheWorstStretchAndExactFixedSegments) {
  CamProblem problem = fig614();
  problem.free = {{3, Bound{205, 355}, {}, Bound{-3, 3}, {}}};
  // Segment 1 is fixed: its own peak, 0.0779244639 in the manual, is above 25 / 510.
  EXPECT_NEAR(lower_bound(problem, Objective::peak_acceleration), 0.0779244639, 1e-10);
  // Its jerk at the start: 60 (100/75^3) - 24 (1/75^2) = 0.00995555...
  EXPECT_NEAR(lower_bound(problem, Objective::peak_jerk), 60 * 100 / 421875.0 - 24 / 5625.0, 1e-15);
  problem.free.push_back({0, {}, {}, {}, Bound{-0.1, 0.1}});
  EXPECT_NEAR(lower_bound(problem, Objective::peak_acceleration), 25.0 / 510, 1e-15);
  const double square = least_square_acceleration({75, 100, 0, 1, {}, {}}) +
                        least_square_acceleration({160, -225, 1, 0, {}, {}});
  EXPECT_NEAR(lower_bound(problem, Objective::rms_acceleration), std::sqrt(square / 360), 1e-15);
}

TEST(LowerBound, CountsThePlacesThatArePassed) {
  // From rest at 0 up to 1 and back to rest at 0 over [0, 1]: for any free values at the top, one
  // side has no more than half of it, so that A >= 2 / (1/2)^2, J >= 6 / (1/2)^3 and, each half at
  // best its cubic, the integral of f''^2 >= 2 * 3 / (1/2)^3.
  CamProblem problem;
  problem.cam.segments = {{Law::quintic, {0.5, 1, 0, 0}}, {Law::quintic, {1, 0, 0, 0}}};
  problem.cam.start = {0, 0, 0, 0};
  const auto expect = [&](double share) {
    const auto is_close = [&](Objective objective, double known) {
      const double bound = lower_bound(problem, objective);
      EXPECT_LE(bound, known * (1 + 1e-12)) << name(objective);
      EXPECT_GE(bound, known * share) << name(objective);
    };
    is_close(Objective::peak_acceleration, 8);
    is_close(Objective::peak_jerk, 48);
    is_close(Objective::rms_acceleration, std::sqrt(48));
  };
  problem.free = {{1, {}, {}, Bound{-1, 1}, Bound{-9, 9}}};
  expect(1 - 1e-12);
  problem.free = {{1, Bound{0.1, 0.9}, {}, Bound{-1, 1}, Bound{-9, 9}}};
  expect(0.92);  // cells of 1/80
}

TEST(LowerBound, IsZeroWhereTheOuterEndIsFree) {
  CamProblem problem = rest_to_rest({0.5}, Objective::peak_acceleration);
  problem.free = {{2, {}, Bound{0, 1}, {}, {}}};
  // The first segment is fixed: that of the 3-4-5 law up to its middle, 10 / sqrt(3).
  EXPECT_NEAR(lower_bound(problem, Objective::peak_acceleration), 10 / std::sqrt(3), 1e-13);
  problem.free = {{1, {}, Bound{0, 1}, {}, {}}, {2, {}, Bound{0, 1}, {}, {}}};
  EXPECT_EQ(lower_bound(problem, Objective::peak_acceleration), 0);
}

}  // namespace
}  // namespace jounce::bound_test
