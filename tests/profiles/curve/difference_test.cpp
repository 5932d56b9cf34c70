// SPDX-License-Identifier: Apache-2.0
#include "jounce/profiles/curve/difference.hpp"

#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "jounce/profiles/error.hpp"
#include "jounce/profiles/moves/s_curve.hpp"

#include "support/random.hpp"

namespace jounce::difference_test {
namespace {

constexpr double pi = std::numbers::pi;

/// Four quintics with a rise, a stretch in step and a return, as a cam has them.
Cam feeder(double return_at = 280, double return_to = 100) {
  return Cam({quintic(75, 0, 0, 0, 100, 1, 0), quintic(125, 100, 1, 0, 225, 1, 0),
              quintic(return_at - 200, 225, 1, 0, return_to, -0.3, 0),
              quintic(360 - return_at, return_to, -0.3, 0, 0, 0, 0)},
             0, Extrapolation::wrap);
}

TEST(Difference, OfACurveAndItselfIsNone) {
  for (const Change& change : compare(feeder(), feeder())) {
    EXPECT_EQ(change.largest.value, 0);
    EXPECT_TRUE(change.none());
  }
  EXPECT_TRUE(knot_changes(feeder(), feeder()).empty());
}

TEST(Difference, FindsABumpThatSamplesMiss) {
  // A line, and a line with the bump 64 h s^3 (1 - s)^3 on a ten-thousandth of it: h at its middle.
  const double h = 1e-3;
  Segment bump = line(1e-4, 0.3, 0.3001);
  bump.degree = 6;
  bump.c[3] = 64 * h;
  bump.c[4] = -192 * h;
  bump.c[5] = 192 * h;
  bump.c[6] = -64 * h;
  const Cam before({line(1, 0, 1)});
  const Cam after({line(0.3, 0, 0.3), bump, line(0.6999, 0.3001, 1)});
  const Changes changes = compare(before, after);
  EXPECT_NEAR(changes[0].largest.value, h, 1e-15);
  EXPECT_NEAR(changes[0].largest.where, 0.30005, 1e-9);
  EXPECT_FALSE(changes[0].none());
  EXPECT_FALSE(changes[0].within(0.9e-3));
  EXPECT_TRUE(changes[0].within(1.1e-3));
  EXPECT_DOUBLE_EQ(changes[0].span(), 1);
}

/// offset + the three cosines about the middle that have these frequencies, over a length of 2.
Segment cosines(double amplitude, std::array<double, 3> frequencies) {
  Segment f;
  f.length = 2;
  f.sines = 3;
  for (std::size_t i = 0; i < 3; ++i)
    f.sine[i] = {amplitude, frequencies[i], pi / 2 - frequencies[i] / 2};
  return f;
}

TEST(Difference, IsExactWhereSixSinesDoNotFitASegment) {
  // All six peak in the middle: 6 there, and the second derivative is -sum w^2 / 4.
  const Cam before({cosines(-1, {5, 7, 11})});
  const Cam after({cosines(1, {6, 13, 17})});
  const Changes changes = compare(before, after);
  EXPECT_NEAR(changes[0].largest.value, 6, 1e-14);
  EXPECT_NEAR(changes[0].largest.where, 1, 1e-7);
  const double w2 = 25.0 + 49 + 121 + 36 + 169 + 289;
  EXPECT_NEAR(changes[2].largest.value, -w2 / 4, 1e-13 * w2);
  EXPECT_NEAR(changes[2].largest.where, 1, 1e-7);
  // The third derivative, sum w^3 sin(w (s - 1/2)) / 8, is odd: its peak by ternary search.
  const auto third = [&](double s) {
    double sum = 0;
    for (const double w : {5.0, 7.0, 11.0, 6.0, 13.0, 17.0})
      sum += w * w * w * std::sin(w * (s - 0.5));
    return std::abs(sum / 8);
  };
  double best = 0;
  for (int i = 0; i <= 200000; ++i) best = std::max(best, third(i / 200000.0));
  EXPECT_NEAR(std::abs(changes[3].largest.value), best, 1e-8 * best);
  EXPECT_GE(std::abs(changes[3].largest.value), best * (1 - 1e-12));
}

/// A curve of random pieces over [start, start + about length].
Cam random_cam(test::Random& random, double start, double length, double size) {
  std::vector<Segment> segments;
  const int n = 1 + random.below(6);
  for (int i = 0; i < n; ++i) {
    Segment f;
    f.length = length / n * random.uniform(0.5, 1.5);
    f.degree = random.below(8);
    for (std::size_t k = 0; k <= static_cast<std::size_t>(f.degree); ++k)
      f.c[k] = size * random.uniform(-1, 1);
    f.sines = random.below(4);
    for (std::size_t k = 0; k < static_cast<std::size_t>(f.sines); ++k)
      f.sine[k] = {size * random.uniform(-1, 1), random.uniform(-10, 10), random.uniform(-3, 3)};
    segments.push_back(f);
  }
  return Cam(std::move(segments), start, Extrapolation::hold);
}

TEST(Difference, IsThatOfTheJetsAndBoundsEverySample) {
  test::Random random(11);
  for (int n = 0; n < 300; ++n) {
    SCOPED_TRACE(n);
    const double length = random.log_uniform(1e-6, 1e6);
    const double size = random.log_uniform(1e-9, 1e9);
    const Cam before = random_cam(random, 0, length, size);
    const Cam after = random_cam(random, random.uniform(-0.2, 0.2) * length, length, size);
    const auto d = difference(before, after);
    const Changes changes = compare(before, after);
    const Changes mirrored = compare(after, before);
    ASSERT_EQ(d.curve.segments().size(), d.rounding.size());
    EXPECT_EQ(d.curve.start(), std::max(before.start(), after.start()));
    EXPECT_NEAR(d.curve.end(), std::min(before.end(), after.end()), 1e-12 * length);
    for (std::size_t i = 0; i < d.rounding.size(); ++i)
      for (const double s : {0.1, 0.5, 0.77}) {
        const double x = d.curve.breaks()[i] + s * d.curve.segments()[i].length;
        const Jet a = before.jet(x);
        const Jet b = after.jet(x);
        const Jet c = d.curve.jet(x);
        for (std::size_t k = 0; k < 4; ++k) {
          const double reach = 40 * d.rounding[i][k];  // x itself is rounded
          EXPECT_NEAR(c[k], b[k] - a[k], reach) << "order " << k << " at " << x;
          EXPECT_LE(std::abs(c[k]), std::abs(changes[k].largest.value) + reach);
        }
      }
    for (std::size_t k = 0; k < 4; ++k)
      EXPECT_NEAR(std::abs(mirrored[k].largest.value), std::abs(changes[k].largest.value),
                  40 * changes[k].rounding);
  }
}

TEST(Difference, IsBlindToRoundingAndToNothingElse) {
  test::Random random(12);
  for (int n = 0; n < 300; ++n) {
    SCOPED_TRACE(n);
    const double length = random.log_uniform(1e-6, 1e6);
    const double size = random.log_uniform(1e-9, 1e9);
    const Cam cam = random_cam(random, 0, length, size);
    std::vector<Segment> cut;  // the same curve in other pieces
    for (const Segment& f : cam.segments()) {
      const double at = random.uniform(0.2, 0.8);
      cut.push_back(part(f, 0, at));
      cut.push_back(part(f, at, 1));
    }
    const Cam pieces(cut, 0, Extrapolation::hold);
    for (const Change& change : compare(cam, pieces))
      EXPECT_TRUE(change.none()) << change.largest.value << " against " << change.rounding;
    const auto knots = knot_changes(cam, pieces);
    EXPECT_EQ(knots.size(), cam.segments().size()) << "only the cuts are new";

    const double step = 1e-12 * magnitude(cam.segments().front());
    const Changes moved = compare(cam, shifted(cam, 0, step));
    EXPECT_FALSE(moved[0].none());
    EXPECT_NEAR(moved[0].largest.value, step, 0.05 * step);
    EXPECT_TRUE(moved[1].none());
  }
}

TEST(Difference, IsOverWhatBothHave) {
  const Cam before({line(360, 0, 360)});
  const Cam after({line(200, 0, 380)}, 100);
  const auto d = difference(before, after);
  EXPECT_EQ(d.curve.start(), 100);
  EXPECT_EQ(d.curve.end(), 300);
  const Changes changes = compare(before, after);
  EXPECT_DOUBLE_EQ(changes[0].largest.value, -100) << "at 100; at 300 it is 80";
  EXPECT_EQ(changes[0].before.max.value, 360) << "ranges are of the whole curves";
  EXPECT_NEAR(changes[1].largest.value, 0.9, 1e-15);
  EXPECT_THROW((void)difference(before, Cam({line(10, 0, 1)}, 360)), InputError);
}

TEST(Difference, ReportsWhereAStepOfADerivativeWasMoved) {
  const Trajectory slow =
      s_curve({.to = 50, .velocity = 10, .acceleration = 20, .jerk = 100}).curve();
  const Trajectory fast =
      s_curve({.to = 50, .velocity = 10, .acceleration = 20, .jerk = 120}).curve();
  const Changes changes = compare(slow, fast);
  EXPECT_NEAR(std::abs(changes[3].largest.value), 100, 1e-9)
      << "one is at 0, the other still at 100";
  EXPECT_GE(changes[3].largest.where, 1.0 / 6 - 1e-12) << "where the jerk of 120 ends";
  EXPECT_NEAR(changes[3].before.max.value, 100, 1e-12);
  EXPECT_NEAR(changes[3].after.max.value, 120, 1e-12);
}

TEST(KnotChange, DistinguishesMovedChangedAddedAndRemoved) {
  const auto moved = knot_changes(feeder(), feeder(300, 100));
  ASSERT_EQ(moved.size(), 1U);
  EXPECT_TRUE(moved[0].moved);
  EXPECT_EQ(moved[0].before->index, 3U);
  EXPECT_EQ(moved[0].before->where, 280);
  EXPECT_EQ(moved[0].after->where, 300);
  EXPECT_FALSE(moved[0].changed[0]) << "still at 100";

  const auto changed = knot_changes(feeder(), feeder(280, 99));
  ASSERT_EQ(changed.size(), 1U);
  EXPECT_FALSE(changed[0].moved);
  EXPECT_TRUE(changed[0].changed[0]);
  EXPECT_FALSE(changed[0].changed[1]);
  EXPECT_DOUBLE_EQ(changed[0].after->jet[0], 99);

  const std::vector<double> fewer{0, 75, 200, 360};
  const auto removed = knot_changes(feeder(), feeder().breaks(), feeder(), fewer);
  ASSERT_EQ(removed.size(), 1U);
  EXPECT_FALSE(removed[0].after);
  const auto added = knot_changes(feeder(), fewer, feeder(), feeder().breaks());
  ASSERT_EQ(added.size(), 1U);
  EXPECT_FALSE(added[0].before);
  EXPECT_EQ(added[0].after->where, 280);
}

TEST(KnotChange, PairsTheNearest) {
  const Cam f({line(10, 0, 10)});
  const std::vector<double> a{0, 1, 2, 10};
  const std::vector<double> b{0, 1.9, 6, 10};
  const auto changes = knot_changes(f, a, f, b);
  ASSERT_EQ(changes.size(), 3U);
  EXPECT_FALSE(changes[0].after) << "1 went: 1.9 is nearest to it, but 2 is nearer to that";
  EXPECT_EQ(changes[0].before->where, 1);
  EXPECT_TRUE(changes[1].moved);
  EXPECT_EQ(changes[1].before->where, 2);
  EXPECT_EQ(changes[1].after->where, 1.9);
  EXPECT_FALSE(changes[2].before);
  EXPECT_EQ(changes[2].after->where, 6);
}

}  // namespace
}  // namespace jounce::difference_test
