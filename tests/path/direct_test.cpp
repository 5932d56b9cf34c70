// SPDX-License-Identifier: Apache-2.0
#include "jounce/path/direct.hpp"

#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "jounce/profiles/error.hpp"
#include "jounce/profiles/limits/limits.hpp"

#include "tests/path/paths.hpp"

namespace jounce::direct_test {
namespace {

const std::vector<Limits> limits{{.velocity = 100, .acceleration = 1000, .jerk = 1e4},
                                 {.velocity = 50, .acceleration = 500, .jerk = 5e3},
                                 {.velocity = 10, .acceleration = 10, .jerk = 10}};

TEST(Direct, FastAxesGoOnTheirOwn) {
  // The first axis alone: 200 / 100 + 100 / 1000 + 1000 / 1e4; the second needs 20 / 50 + 0.1 + 0.1.
  const std::vector<Trajectory> axes = direct({}, {200, 20, 0}, limits);
  ASSERT_EQ(axes.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(axes[i].end(), 2.2, 1e-12);
    EXPECT_TRUE(check(axes[i], limits[i]).ok());
  }
  EXPECT_EQ(axes[1].at(axes[1].end(), Side::left).position, 20);
  EXPECT_NEAR(axes[1].at(0.6).position, 20, 1e-12);  // 20 / 50 + 50 / 500 + 500 / 5e3 = 0.6 s
  EXPECT_LT(axes[1].at(0.59).position, 20);
  EXPECT_EQ(axes[2].at(1).position, 0);
}

TEST(Direct, PathInvariantIsAStraightLine) {
  const std::vector<Trajectory> axes =
      direct({1, 2, 3}, {201, -58, 3}, limits, DirectMode::path_invariant);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_TRUE(check(axes[i], limits[i]).ok());
  for (int k = 0; k <= 100; ++k) {
    const double t = axes[0].end() * k / 100;
    const double share = (axes[0].at(t, Side::left).position - 1) / 200;
    EXPECT_NEAR(axes[1].at(t, Side::left).position, 2 - 60 * share, 1e-11);
  }
}

/// The plan has the motions of direct(), which has another code for its polynomials.
TEST(Direct, AFastMoveAsAPlanIsTheSameMotion) {
  const Point from{1, -2, 3};
  const Point to{201, 18, 2};
  const std::vector<Trajectory> axes = direct(from, to, limits);
  const Plan made = direct_plan(from, to, limits);
  ASSERT_NEAR(made.duration(), axes[0].end(), 1e-12);
  std::array<Motion, 3> at;
  for (int k = 0; k <= 1000; ++k) {
    const double t = made.duration() * k / 1000;
    made.at(t, at);
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_NEAR(at[i].position, axes[i].at(t, Side::left).position, 1e-10);
      EXPECT_NEAR(at[i].velocity, axes[i].at(t, Side::left).velocity, 1e-8);
    }
  }
  const PlanAxes curves = to_axes(made);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_TRUE(check(curves.curves[i], limits[i]).ok());
  EXPECT_NEAR(made.path().length(), std::sqrt(200 * 200 + 20 * 20 + 1), 1e-9);
  EXPECT_THROW(direct_plan(from, from, limits), InputError);
}

TEST(Direct, RejectsBadInput) {
  EXPECT_THROW(direct({}, {}, limits), InputError);
  EXPECT_THROW(direct({}, {1}, {}), InputError);
  EXPECT_THROW(direct({}, {std::nan("")}, limits), InputError);
  EXPECT_THROW(direct({}, {5}, {{.position_max = 4, .velocity = 1}}), InputError);
}

/// A line at 100 mm/s is left at 90 mm for 100 mm: the fastest stop, 0.2 s. For 50 mm it turns back.
TEST(Aborting, LeavesALineFromItsMovingState) {
  Program p(1);
  p.set({.velocity = 100});
  p.line({200});
  const Plan made = plan(p, path_tests::usual(1));
  const Trajectory near = aborted(made, 1, {100}).front();
  EXPECT_NEAR(near.end(), 1.2, 1e-9);
  EXPECT_NEAR(near.at(near.end(), Side::left).position, 100, 1e-9);
  // It cannot end before 1.2 s, and a stop with a move back bounds it: 50 mm take 2 (v / A + A / J) at their peak v,
  // for which v^2 / A + v A / J = 50.
  const double v = -50 + std::sqrt(2500 + 50e3);
  const double back = aborted(made, 1, {50}).front().end();
  EXPECT_GT(back, 1.2);
  EXPECT_LE(back, 1.2 + 2 * (v / 1000 + 0.1) + 1e-9);
}

TEST(Aborting, KeepsTheLimitsAndIsContinuous) {
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    SCOPED_TRACE(seed);
    path_tests::Random random(seed);
    GroupLimits group = path_tests::usual(2, random.log_between(1e3, 1e6));
    for (Limits& axis : group.axes) axis.velocity = random.log_between(20, 500);
    Program p(2);
    p.set({.velocity = 100, .corner = Corner::deviation, .value = 1});
    Point at{};
    for (int i = 0; i < 5; ++i) {
      at[0] += random.between(-50, 50);
      at[1] += random.between(-50, 50);
      p.line(at);
    }
    const Plan made = plan(p, group);
    const double t = made.duration() * random();
    const Point to{random.between(-100, 100), random.between(-100, 100)};
    const PlanAxes motion{aborted(made, t, to), {}};
    EXPECT_LE(path_tests::excess(motion, group), 1e-12);
    std::vector<Motion> was(2);
    made.at(t / 2, was);
    for (std::size_t i = 0; i < 2; ++i) {
      const Trajectory& f = motion.curves[i];
      EXPECT_NEAR(f.end(), motion.curves[0].end(), 1e-9);
      EXPECT_NEAR(f.at(t / 2).position, was[i].position, 1e-9);
      EXPECT_NEAR(f.at(f.end(), Side::left).position, to[i], 1e-8);
      EXPECT_NEAR(f.at(f.end(), Side::left).velocity, 0, 1e-6);
      for (int order = 0; order < 2; ++order)
        EXPECT_LE(std::abs(largest_jump(f, order).step), 1e-6) << order;
      EXPECT_LE(std::abs(largest_jump(f, 2).step), 1e-4);
    }
    if (HasFailure()) break;
  }
  Program p(1);
  p.set({.velocity = 100});
  p.line({200});
  EXPECT_THROW(aborted(plan(p, path_tests::usual(1)), 3, {1}), InputError);
}

}  // namespace
}  // namespace jounce::direct_test
