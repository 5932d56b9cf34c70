// SPDX-License-Identifier: Apache-2.0
#include "jounce/path/hold.hpp"

#include <gtest/gtest.h>

#include "jounce/profiles/error.hpp"

#include "tests/path/paths.hpp"

namespace jounce::hold_test {
namespace {

using path_tests::Random;
using path_tests::usual;

Program zigzag(Random& random, std::size_t count, double reach) {
  Program p(2);
  p.set({.velocity = 100, .corner = Corner::deviation, .value = random.log_between(0.05, 5)});
  Point at{};
  for (std::size_t i = 0; i < count; ++i) {
    at[0] += random.between(-reach, reach);
    at[1] += random.between(-reach, reach);
    p.line(at, static_cast<int>(i + 1));
    if (random() < 0.1) p.dwell(0.1);
  }
  return p;
}

// The velocity of a corner that a motion does not pass was read from before the first stretch of its law.
TEST(Hold, ACornerBeforeAResumedMotionHasNoVelocity) {
  Program p(2);
  p.set({.velocity = 100, .corner = Corner::deviation, .value = 0.5});
  p.line({20, 0}, 1);
  p.line({20, 20}, 2);
  p.line({40, 20}, 3);
  const Plan made = plan(p, usual(2));
  const std::vector<CornerRecord> corners = resumed(made, 30).corners();
  ASSERT_EQ(corners.size(), 2u);
  EXPECT_EQ(corners[0].velocity, 0);
  EXPECT_GT(corners[1].velocity, 0);
}

TEST(Hold, AnyInstantStaysOnThePathWithinTheLimits) {
  for (std::uint64_t seed = 1; seed <= 400; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const GroupLimits limits = usual(2, random.log_between(1e3, 1e6));
    const Plan made = plan(zigzag(random, 8, random.log_between(1, 100)), limits);
    const double t = made.duration() * random();
    const Plan held = halted(made, t);
    const PlanAxes before = to_axes(held);
    EXPECT_LE(path_tests::worst_ratio(before, limits), 1 + 1e-12);
    EXPECT_LE(held.duration(), made.duration() * (1 + 1e-12));
    EXPECT_GE(held.duration(), t * (1 - 1e-12));
    // The same motion up to t; at the end at rest.
    std::vector<Motion> was(2);
    std::vector<Motion> is(2);
    made.at(t / 2, was);
    held.at(t / 2, is);
    for (std::size_t i = 0; i < 2; ++i) {
      EXPECT_NEAR(is[i].position, was[i].position, 1e-10);
      const Trajectory& f = before.curves[i];
      EXPECT_NEAR(f.at(f.end(), Side::left).velocity, 0, 1e-7);
      EXPECT_LE(std::abs(largest_jump(f, 0).step), 1e-9);
      EXPECT_LE(std::abs(largest_jump(f, 1).step), 1e-6);
    }
    const LawInterval& last = held.law().stretches().back();
    if (last.start + last.length >= made.path().length() * (1 - 1e-12)) continue;
    const Plan rest = resumed(made, held);
    const PlanAxes behind = to_axes(rest);
    EXPECT_LE(path_tests::worst_ratio(behind, limits), 1 + 1e-12);
    for (std::size_t i = 0; i < 2; ++i) {
      const Trajectory& f = behind.curves[i];
      EXPECT_NEAR(f.at(0).position,
                  before.curves[i].at(before.curves[i].end(), Side::left).position, 1e-9);
      made.at(made.duration(), was);
      EXPECT_NEAR(f.at(f.end(), Side::left).position, was[i].position, 1e-9);
      EXPECT_NEAR(f.at(f.end(), Side::left).velocity, 0, 1e-7);
      EXPECT_LE(std::abs(largest_jump(f, 1).step), 1e-6);
    }
    // No station is faster than in the plan, and all dwells are there.
    double dwells = 0;
    for (const LawInterval& stretch : made.law().stretches())
      dwells += stretch.pieces == 0 ? stretch.duration : 0;
    for (const Plan* half : {&held, &rest})
      for (const LawInterval& stretch : half->law().stretches()) {
        dwells -= stretch.pieces == 0 ? stretch.duration : 0;
        for (const LawInterval& planned : made.law().stretches())
          if (std::abs(planned.start + planned.length - stretch.start - stretch.length) < 1e-9 &&
              stretch.pieces > 0 && planned.pieces > 0) {
            EXPECT_LE(stretch.v1, planned.v1 * (1 + 1e-9));
          }
      }
    EXPECT_NEAR(dwells, 0, 1e-12);
    if (HasFailure()) break;
  }
}

TEST(Hold, InACruiseItIsTheFastestStop) {
  Program p(1);
  p.set({.velocity = 100});
  p.line({200});
  const Plan held = halted(plan(p, usual(1)), 1);
  EXPECT_NEAR(held.duration(), 1 + 100.0 / 1000 + 1000.0 / 1e4, 1e-12);
}

TEST(Hold, RejectsBadInput) {
  Program p(1);
  p.set({.velocity = 100});
  p.line({200});
  const Plan made = plan(p, usual(1));
  EXPECT_THROW(halted(made, -1), InputError);
  EXPECT_THROW(halted(made, 3), InputError);
  EXPECT_THROW(resumed(made, made), InputError);
}

}  // namespace
}  // namespace jounce::hold_test
