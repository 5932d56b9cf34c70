// SPDX-License-Identifier: Apache-2.0
#include "jounce/profiles/curve/extrema.hpp"

#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "jounce/profiles/curve/roots.hpp"
#include "jounce/profiles/error.hpp"
#include "jounce/profiles/limits/limits.hpp"

#include "support/random.hpp"

namespace jounce::extrema_test {
namespace {

TEST(Extrema, OfARestToRestQuinticAreItsClosedForms) {
  const Trajectory f({quintic(1, 0, 0, 0, 1, 0, 0)});  // 3-4-5 polynomial
  const Ranges r = extrema(f);
  EXPECT_NEAR(r[1].max.value, 1.875, 1e-14);
  EXPECT_NEAR(r[1].max.where, 0.5, 1e-12);
  EXPECT_NEAR(r[2].max.value, 10 / std::sqrt(3), 1e-13);
  EXPECT_NEAR(r[2].max.where, (3 - std::sqrt(3)) / 6, 1e-12);
  EXPECT_NEAR(r[2].min.where, (3 + std::sqrt(3)) / 6, 1e-12);
  EXPECT_NEAR(r[3].max.value, 60, 1e-12);
  EXPECT_NEAR(r[3].min.value, -30, 1e-12);
}

TEST(Extrema, OfARiseFromRestToRestLieAtItsKnots) {
  // Near its end a rise is flat to rounding, and its polynomial may round above its end value there.
  test::Random random(345);
  for (int i = 0; i < 2000; ++i) {
    const double from = random.uniform(-1, 1);
    const double to = random.uniform(-1, 1);
    const double length = random.log_uniform(1e-3, 1e3);
    const Range r = extrema(Cam({quintic(length, from, 0, 0, to, 0, 0)}), 0);
    const Extremum& start = from < to ? r.min : r.max;
    const Extremum& end = from < to ? r.max : r.min;
    ASSERT_EQ(start.where, 0) << "from " << from << " to " << to << " over " << length;
    ASSERT_EQ(end.where, length) << "from " << from << " to " << to << " over " << length;
  }
}

TEST(Extrema, SeeAPeakThatAThousandSamplesMiss) {
  // A line with a bump 1e-4 wide in its middle: no multiple of 1/1000 comes near its top.
  const double w = 1e-4;
  const double x = 0.5004;
  const Segment bump = quintic(w / 2, x, 1, 0, x + w / 2 + 0.01, 1, 0);
  const Segment fall = quintic(w / 2, x + w / 2 + 0.01, 1, 0, x + w, 1, 0);
  const Trajectory f({line(x, 0, x), bump, fall, line(1 - x - w, x + w, 1)});
  double sampled = 0;
  for (int i = 0; i <= 1000; ++i) sampled = std::max(sampled, f.at(i / 1000.0).velocity);
  EXPECT_DOUBLE_EQ(sampled, 1);
  EXPECT_GT(extrema(f, 1).max.value, 300);
}

TEST(Extrema, TakeBothSidesOfAJump) {
  const Trajectory f({line(1, 0, 2), line(1, -3, 0)});
  const Range r = extrema(f, 0);
  EXPECT_DOUBLE_EQ(r.max.value, 2);
  EXPECT_EQ(r.max.side, Side::left);
  EXPECT_DOUBLE_EQ(r.max.where, 1);
  EXPECT_DOUBLE_EQ(r.min.value, -3);
  EXPECT_EQ(r.min.side, Side::right);
  const Jump jump = largest_jump(f, 0);
  EXPECT_DOUBLE_EQ(jump.step, -5);
  EXPECT_DOUBLE_EQ(jump.where, 1);
}

TEST(Extrema, OfSinesAreExact) {
  // z - sin(2 pi z)/(2 pi): the inclined sine.
  Segment f = line(1, 0, 1);
  f.sines = 1;
  f.sine[0] = {-1 / (2 * std::numbers::pi), 2 * std::numbers::pi, 0};
  const Ranges r = extrema(Trajectory({f}));
  EXPECT_NEAR(r[1].max.value, 2, 1e-15);
  EXPECT_NEAR(r[2].max.value, 2 * std::numbers::pi, 1e-14);
  EXPECT_NEAR(r[2].max.where, 0.25, 1e-9);
  EXPECT_NEAR(r[3].min.value, -4 * std::numbers::pi * std::numbers::pi, 1e-12);
}

TEST(Extrema, DoNotDependOnTheUnit) {
  for (const double p : {1e-9, 1.0, 1e9})
    for (const double t : {1e-6, 1.0, 1e6}) {
      const Trajectory f({quintic(t, 0, 0, 0, p, 0.5 * p / t, 0)});
      const Trajectory unit({quintic(1, 0, 0, 0, 1, 0.5, 0)});
      double factor = p;
      for (int k = 0; k < 4; ++k, factor /= t)
        EXPECT_NEAR(extrema(f, k).peak().value / factor, extrema(unit, k).peak().value,
                    1e-12 * std::abs(extrema(unit, k).peak().value));
    }
}

TEST(Extrema, KeepARootThatRoundingPutsOnABisectionPoint) {
  // 2026-11-21: the peak of a rest-to-rest quintic lies at its middle, where the two halves of the
  // bisection meet; by rounding neither half saw a change of sign, and the peak velocity came out
  // 0.
  const double t = 0.1988858103462883 / 2;
  const double r = -10.213799038291999;
  const double f = 6.9847148702096646;
  const Trajectory there_and_back(
      {quintic(t, f, 0, 0, f + r, 0, 0), quintic(t, f + r, 0, 0, f, 0, 0)});
  EXPECT_NEAR(extrema(there_and_back, 1).max.value, 1.875 * -r / t, 1e-11);
  EXPECT_NEAR(extrema(there_and_back, 1).min.value, 1.875 * r / t, 1e-11);

  test::Random random(4);
  for (int i = 0; i < 20'000; ++i) {
    const double length = random.log_uniform(1e-3, 1e3);
    const double from = random.uniform(-10, 10);
    const double rise = random.uniform(-10, 10);
    const Trajectory one({quintic(length, from, 0, 0, from + rise, 0, 0)});
    const double peak = 1.875 * rise / length;
    ASSERT_NEAR(extrema(one, 1).peak().value, peak, 1e-13 * std::abs(peak) + 1e-14 / length) << i;
  }
}

TEST(Extrema, OfAConstantAreTheConstant) {
  const Range r = extrema(Trajectory({line(1, 7, 7)}), 0);
  EXPECT_EQ(r.min.value, 7);
  EXPECT_EQ(r.max.value, 7);
}

/// The bounds of a segment only save work: the ranges and their places are those of all segments.
TEST(Extrema, OfACurveAreThoseOfEachOfItsSegments) {
  test::Random random(143);
  for (int i = 0; i < 300; ++i) {
    std::vector<Segment> segments;
    for (int k = 0; k < 40; ++k) {
      Segment f{.length = random.log_uniform(1e-4, 1e2), .degree = k % (Segment::max_degree + 1)};
      const double size = random.log_uniform(1e-3, 1e3);
      f.c[0] = random.uniform(-1e3, 1e3);
      for (int n = 1; n <= f.degree; ++n)
        f.c[static_cast<std::size_t>(n)] = size * random.uniform(-1, 1);
      if (k % 5 == 0) {
        f.sines = 1;
        f.sine[0] = {random.uniform(-1, 1), random.uniform(-7, 7), random.uniform(-3, 3)};
      }
      segments.push_back(f);
    }
    const Trajectory curve(segments);
    const Ranges all = extrema(curve);
    for (std::size_t order = 0; order < all.size(); ++order) {
      Range wanted = segment_range(curve, 0, static_cast<int>(order));
      for (std::size_t k = 1; k < segments.size(); ++k) {
        const Range here = segment_range(curve, k, static_cast<int>(order));
        if (here.min.value < wanted.min.value) wanted.min = here.min;
        if (here.max.value > wanted.max.value) wanted.max = here.max;
      }
      ASSERT_EQ(all[order].min.value, wanted.min.value) << i << ", order " << order;
      ASSERT_EQ(all[order].max.value, wanted.max.value) << i << ", order " << order;
      ASSERT_EQ(all[order].min.where, wanted.min.where) << i << ", order " << order;
      ASSERT_EQ(all[order].max.where, wanted.max.where) << i << ", order " << order;
    }
  }
}

TEST(Extrema, RejectAnOrderOutOfRange) {
  const Trajectory f({line(1, 0, 1)});
  for (const int order : {-1, 4}) {
    EXPECT_THROW(extrema(f, order), InputError);
    EXPECT_THROW(segment_range(f, 0, order), InputError);
    EXPECT_THROW(largest_jump(f, order), InputError);
    EXPECT_THROW(crossings(f, order, 0), InputError);
    EXPECT_THROW(static_cast<void>(check_continuity(f, order)), InputError);
  }
}

}  // namespace
}  // namespace jounce::extrema_test
