// SPDX-License-Identifier: Apache-2.0
#include "jounce/path/overlap.hpp"

#include <gtest/gtest.h>

#include "jounce/profiles/error.hpp"

#include "tests/path/paths.hpp"

namespace jounce::overlap_test {
namespace {

using path_tests::Random;
using path_tests::usual;

Program square(double turned = 0) {
  Program p(2);
  p.set({.velocity = 100, .corner = Corner::stop});
  const double c = std::cos(turned);
  const double s = std::sin(turned);
  int line = 0;
  for (const auto& [x, y] : {std::pair{100.0, 0.0}, {100.0, 100.0}, {0.0, 100.0}, {0.0, 0.0}})
    p.line({c * x - s * y, s * x + c * y}, ++line);
  return p;
}

double worst(const Overlapped& motion, const GroupLimits& limits) {
  return path_tests::worst_ratio({motion.axes, {}}, limits);
}

/// tests/oracle/path.json, closed form 5: e = |D| x(tau / 2), x(t) = J t^3 / 6 up to A / J; T = 4.8 - 3 tau.
TEST(Overlap, OfASquareHasItsClosedForm) {
  for (const auto& [e, tau, time] : {std::tuple{1.0, 0.150283, 4.349152}, {0.05, 0.0, 4.633906}}) {
    const Overlapped motion = overlapped(square(), usual(2), {.deviation = e});
    const double half = std::cbrt(6 * e / std::sqrt(2.0) / 1e4);
    EXPECT_NEAR(motion.corners[1].overlap, 2 * half, 1e-9);
    if (tau > 0) {
      EXPECT_NEAR(motion.corners[1].overlap, tau, 1e-6);
    }
    EXPECT_NEAR(motion.duration, time, 1e-6);
    EXPECT_NEAR(motion.duration, 4.8 - 6 * half, 1e-9);
    EXPECT_NEAR(motion.stop_duration, 4.8, 1e-12);
    for (const OverlapRecord& corner : motion.corners) {
      EXPECT_NEAR(corner.deviation, e, 1e-9);
      EXPECT_NEAR(corner.one_sided, e / std::sqrt(2.0), 1e-9);  // both trims are equal
    }
    EXPECT_LE(worst(motion, usual(2)), 1 + 1e-12);
  }
}

/// Without a bound the whole ramps overlap: 0.2 s each.
TEST(Overlap, OfTheWholeRampsIsTheLongest) {
  const Overlapped motion = overlapped(square(), usual(2));
  EXPECT_NEAR(motion.duration, 4.8 - 3 * 0.2, 1e-9);
  EXPECT_NEAR(overlapped(square(), usual(2), {.share = 0.5}).duration, 4.8 - 3 * 0.1, 1e-9);
  EXPECT_NEAR(overlapped(square(), usual(2), {.share = 0}).duration, 4.8, 1e-12);
}

/// A naive overlap of the square turned by 45 degrees takes twice the jerk of an axis (spec of the seed: 2.00 J).
TEST(Overlap, OfATurnedSquareKeepsTheLimits) {
  const GroupLimits limits = usual(2);
  const Overlapped motion = overlapped(square(std::acos(-1) / 4), limits, {.deviation = 1});
  EXPECT_LE(worst(motion, limits), 1 + 1e-12);
  EXPECT_LE(motion.duration, motion.stop_duration);
}

TEST(Overlap, OfRandomLinesKeepsLimitsAndDeviation) {
  for (std::uint64_t seed = 1; seed <= 400; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    GroupLimits limits = usual(2, random.log_between(1e3, 1e6));
    for (Limits& axis : limits.axes) axis.velocity = random.log_between(20, 500);
    Program p(2);
    p.set({.velocity = 100});
    const double reach = random.log_between(1, 100);
    std::vector<Point> points{{}};
    Point at{};
    for (int i = 0; i < 8; ++i) {
      at[0] += random.between(-reach, reach);
      at[1] += random.between(-reach, reach);
      p.line(at, i + 1);
      points.push_back(at);
      if (random() < 0.1) p.dwell(0.1);
    }
    const double e = random.log_between(1e-3, 10);
    const Overlapped motion = overlapped(p, limits, {.deviation = e});
    EXPECT_LE(worst(motion, limits), 1 + 1e-12);
    EXPECT_LE(motion.duration, motion.stop_duration * (1 + 1e-12));
    for (std::size_t i = 0; i < 2; ++i) {
      const Trajectory& f = motion.axes[i];
      EXPECT_NEAR(f.end(), motion.duration, 1e-9);
      EXPECT_NEAR(f.at(f.end(), Side::left).position, at[i], 1e-9);
      EXPECT_LE(std::abs(largest_jump(f, 0).step), 1e-9);
      EXPECT_LE(std::abs(largest_jump(f, 1).step), 1e-6);
    }
    for (std::size_t k = 0; k < motion.corners.size(); ++k) {
      const OverlapRecord& corner = motion.corners[k];
      EXPECT_LE(corner.deviation, e * (1 + 1e-12));
      // An independent look: samples come as near to the corner as the record states, and no nearer.
      double nearest = 1e300;
      for (int s = 0; s <= 2000; ++s) {
        const double t = corner.time + corner.overlap * s / 2000;
        nearest = std::min(nearest, std::hypot(motion.axes[0].at(t).position - points[k + 1][0],
                                               motion.axes[1].at(t).position - points[k + 1][1]));
      }
      EXPECT_GE(nearest, corner.deviation - 1e-9);
      EXPECT_LE(nearest, corner.deviation + 100 * corner.overlap / 2000);
    }
    if (HasFailure()) break;
  }
}

TEST(Overlap, RejectsWhatItCannotDo) {
  EXPECT_THROW(overlapped(square(), usual(2), {.deviation = 0}), InputError);
  EXPECT_THROW(overlapped(square(), usual(2), {.share = 1.5}), InputError);
  Program p(2);
  p.arc(arc_about({}, {50, 0}, {100, 0}, Plane{0, 1}, ArcRotation::clockwise), 7);
  try {
    (void)overlapped(p, usual(2));
    ADD_FAILURE();
  } catch (const InputError& error) {
    EXPECT_EQ(error.line(), 7);
  }
}

}  // namespace
}  // namespace jounce::overlap_test
