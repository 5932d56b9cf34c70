// SPDX-License-Identifier: Apache-2.0
#include "jounce/path/refine.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>

#include <gtest/gtest.h>

#include "jounce/path/along.hpp"
#include "jounce/path/hold.hpp"

#include "path/src/refine/speed_problem.hpp"
#include "tests/path/paths.hpp"

// The times 4.528 s (square) and 3.337 s (circle) are those of an independent sequential linear
// program over the squared velocity on the same paths, in the notes from which the module was made.
namespace jounce::refine_test {
namespace {

GroupLimits two_axes() {
  return {.axes = std::vector<Limits>(2, {.acceleration = 1000, .jerk = 1e4})};
}

Program square() {
  Program p(2);
  p.set({.velocity = 100, .corner = Corner::deviation, .value = 1});
  for (const Point& to : {Point{100, 0}, Point{100, 100}, Point{0, 100}, Point{0, 0}}) p.line(to);
  return p;
}

/// A circle of radius 50 mm in chords of 0.5 mm.
Program chords() {
  Program p(2, {50, 0});
  p.set({.velocity = 100, .corner = Corner::average, .value = 0.05});
  constexpr int count = 628;
  for (int i = 1; i <= count; ++i) {
    const double angle = 2 * std::numbers::pi * i / count;
    p.line({50 * std::cos(angle), i == count ? 0 : 50 * std::sin(angle)}, i);
  }
  return p;
}

void expect_within_limits(const Plan& plan) {
  const PlanAxes axes = to_axes(plan);
  for (std::size_t i = 0; i < axes.curves.size(); ++i) {
    EXPECT_TRUE(check(axes.curves[i], plan.given().limits.axes[i]).ok()) << i;
    EXPECT_TRUE(check_continuity(axes.curves[i], 2).ok()) << i;
  }
  EXPECT_TRUE(check_along(plan).ok());
  EXPECT_GE(plan.duration(), lower_bound(plan));
}

TEST(SpeedProblem, ReachesTheClosedFormOfALine) {
  // A line of 1 with |acceleration| <= 2 and velocity <= v: 2 sqrt(1 / 2), or 1 / v + v / 2.
  constexpr std::size_t cells = 200;
  for (const double v : {10.0, 0.5}) {
    SpeedProblem p;
    p.cells.assign(cells, 1.0 / cells);
    p.most.assign(cells + 1, v * v);
    for (std::size_t k = 0; k < cells; ++k) {
      SpeedRow row{{}, 1, static_cast<std::uint32_t>(std::min(k, cells - 2))};
      row.c[k - row.first] = -0.5 * cells / 2;
      row.c[k - row.first + 1] = 0.5 * cells / 2;
      p.rows.push_back(row);
    }
    std::vector<double> b(cells + 1, 0.0);
    for (std::size_t k = 1; k < cells; ++k) b[k] = 1e-3;
    ASSERT_LT(p.use(b), 1);
    b = fastest_speeds(p, std::move(b), 1e-6);
    EXPECT_LT(p.use(b), 1);
    const double least = v > 1 ? 2 * std::sqrt(0.5) : 1 / v + v / 2;
    EXPECT_GE(p.duration(b), least * (1 - 1e-12));
    EXPECT_LE(p.duration(b), least * (1 + 1e-2 / 2));
  }
}

TEST(Refined, ComesNearTheFastestLaw) {
  const Plan corners = plan(square(), two_axes());
  const Plan faster = refined(corners);
  EXPECT_LE(faster.duration(), 1.003 * 4.528);
  EXPECT_LT(faster.duration(), corners.duration());
  expect_within_limits(faster);
  const Plan circle = refined(plan(chords(), two_axes()));
  EXPECT_LE(circle.duration(), 1.005 * 3.337);
  expect_within_limits(circle);
}

TEST(Refined, KeepsPathEndsAndDwells) {
  Program p = square();
  p.dwell(0.25);
  p.line({50, 50});
  const Plan before = plan(p, two_axes());
  const Plan after = refined(before);
  EXPECT_LT(after.duration(), before.duration());
  EXPECT_EQ(after.path().length(), before.path().length());
  EXPECT_EQ(after.junctions().size(), before.junctions().size());
  EXPECT_EQ(after.stop_duration(), before.stop_duration());
  const auto dwells = [](const Plan& plan) {
    double sum = 0;
    for (const LawInterval& s : plan.law().stretches())
      if (s.pieces == 0) sum += s.duration;
    return sum;
  };
  EXPECT_DOUBLE_EQ(dwells(after), 0.25);
  std::vector<Motion> end(2);
  after.at(after.duration(), end);
  EXPECT_NEAR(end[0].position, 50, 1e-9);
  EXPECT_NEAR(end[0].velocity, 0, 1e-9);
  expect_within_limits(after);
  // The line after the dwell already has the fastest law.
  EXPECT_DOUBLE_EQ(after.law().stretches().back().duration,
                   before.law().stretches().back().duration);
}

TEST(Refined, OfArcsAndPathLimitsKeepsAll) {
  Program p(2);
  p.set({.velocity = 80, .corner = Corner::deviation, .value = 0.5});
  p.line({60, 0}, 1);
  p.arc(arc_about({60, 0}, {60, 30}, {60, 60}, Plane{0, 1}, ArcRotation::counterclockwise), 2);
  p.line({0, 60}, 3);
  p.line({-20, 20}, 4);
  GroupLimits limits = two_axes();
  limits.path = {.acceleration = 800,
                 .deceleration = 500,
                 .normal_acceleration = 90,
                 .total_acceleration = 850};
  const Plan before = plan(p, limits);
  const Plan after = refined(before);
  EXPECT_LE(after.duration(), before.duration());
  const PlanAxes axes = to_axes(after);
  for (std::size_t i = 0; i < 2; ++i) EXPECT_TRUE(check(axes.curves[i], limits.axes[i]).ok()) << i;
  EXPECT_TRUE(check_along(after).ok());
}

TEST(Refined, OfOneLineIsThePlanItself) {
  Program p(2);
  p.set({.velocity = 100});
  p.line({200, 100});
  const Plan before = plan(p, two_axes());
  EXPECT_EQ(refined(before).law().stretches().size(), before.law().stretches().size());
}

TEST(Refined, DependsOnItsArgumentsOnly) {
  const Plan a = refined(plan(square(), two_axes()));
  const Plan b = refined(plan(square(), two_axes()));
  ASSERT_EQ(a.law().stretches().size(), b.law().stretches().size());
  for (std::size_t i = 0; i < a.law().stretches().size(); ++i)
    EXPECT_EQ(a.law().stretches()[i].duration, b.law().stretches()[i].duration);
}

/// Lines and half circles with random lengths, limits and corners.
Program random_program(path_tests::Random& random, GroupLimits& limits) {
  Program p(2);
  limits = two_axes();
  for (Limits& l : limits.axes)
    l = {.velocity = random.log_between(30, 300),
         .acceleration = random.log_between(300, 3000),
         .jerk = random.log_between(3e3, 1e5)};
  const Corner corner = random() < 0.3 ? Corner::average : Corner::deviation;
  p.set({.velocity = random.log_between(20, 200),
         .corner = corner,
         .value = random.log_between(0.01, 1)});
  const int count = 2 + static_cast<int>(random() * 8);
  for (int i = 1; i <= count; ++i) {
    const Point from = p.position();
    const double dx = random.between(-20, 20);
    const double dy = random.between(-20, 20);
    if (corner == Corner::deviation && random() < 0.2)
      p.arc(arc_about(from, {from[0] + dx / 2, from[1] + dy / 2}, {from[0] + dx, from[1] + dy},
                      Plane{0, 1}, ArcRotation::clockwise),
            i);
    else
      p.line({from[0] + dx, from[1] + dy}, i);
    if (random() < 0.1) p.dwell(random());
  }
  return p;
}

TEST(Refined, OfRandomProgramsKeepsTheGuaranteesOfAPlan) {
  const char* given = std::getenv("JOUNCE_REFINED_PROGRAMS");
  const int count = given != nullptr ? std::atoi(given) : 20;
  for (int i = 0; i < count; ++i) {
    path_tests::Random random(static_cast<std::uint64_t>(i + 1));
    GroupLimits limits;
    const Program program = random_program(random, limits);
    const Plan before = plan(program, limits);
    const Plan after = refined(before);
    EXPECT_LE(after.duration(), before.duration()) << i;
    EXPECT_GE(after.duration(), lower_bound(after) * (1 - 1e-12)) << i;
    const PlanAxes axes = to_axes(after);
    EXPECT_LE(path_tests::excess(axes, limits), 1e-12) << i;
    EXPECT_TRUE(check_along(after).ok()) << i;
    path_tests::expect_whole(after, axes, program);
  }
}

TEST(Refined, CanBeHeldAndResumed) {
  const Plan motion = refined(plan(square(), two_axes()));
  const Plan held = halted(motion, 0.7 * motion.duration());
  std::vector<Motion> end(2);
  held.at(held.duration(), end);
  EXPECT_NEAR(end[0].velocity, 0, 1e-9);
  EXPECT_NEAR(end[1].velocity, 0, 1e-9);
}

}  // namespace
}  // namespace jounce::refine_test
