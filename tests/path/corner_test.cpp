// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "jounce/path/along.hpp"
#include "jounce/path/hold.hpp"

#include "path/src/corners/turn.hpp"
#include "tests/path/paths.hpp"

namespace jounce::corner_test {
namespace {

using path_tests::usual;

TEST(Turn, OffsetsOfTheTable) {
  // spec/path.md 2.1: the parabola 1/8, the triangle 1/12.
  EXPECT_NEAR(turn_offset(0), 1.0 / 8, 1e-16);
  EXPECT_NEAR(turn_offset(0.5), 1.0 / 12, 1e-16);
  for (const double share : {0.01, 0.1, 0.25, 0.4, 0.5})
    EXPECT_NEAR(turn_rise(share, 0.5)[0], turn_offset(share), 1e-15);
}

TEST(Turn, TheFastestIsTheBestOfAll) {
  path_tests::Random random(1);
  for (int i = 0; i < 2000; ++i) {
    const TurnRates rates{random.log_between(1, 1e6), random.log_between(1, 1e9)};
    const double offset = random.log_between(1e-4, 1e2);
    const double length = random.log_between(1e-3, 1e3);
    const Turn best = fastest_turn(rates, offset, length);
    EXPECT_LE(best.length * turn_offset(best.share), offset * (1 + 1e-12));
    EXPECT_LE(best.length, length * (1 + 1e-15));
    for (int k = 1; k <= 500; ++k) {
      const double share = 0.001 * k;
      const double l = std::min(offset / turn_offset(share), length);
      EXPECT_LE(turn_velocity(rates, share, l), best.velocity * (1 + 1e-9))
          << share << " " << best.share;
    }
  }
}

TEST(Turn, TheLeastIsTheBestOfAll) {
  path_tests::Random random(2);
  for (int i = 0; i < 2000; ++i) {
    const TurnRates rates{random.log_between(1, 1e6), random.log_between(1, 1e9)};
    const double v = random.log_between(1e-2, 1e3);
    const Turn least = least_turn(rates, v);
    EXPECT_GE(turn_velocity(rates, least.share, least.length), v * (1 - 1e-12));
    for (int k = 1; k <= 500; ++k) {
      const double share = 0.001 * k;
      const double l = std::max(v * v / (rates.acceleration * (1 - share)),
                                std::sqrt(v * v * v / (rates.jerk * share * (1 - share))));
      EXPECT_GE(l * turn_offset(share), least.length * turn_offset(least.share) * (1 - 1e-9));
    }
  }
}

/// 100 mm along x, then the arc of radius 50 to one side, or a line up.
Program joint(Corner corner, double value, int side) {
  Program p(2);
  p.set({.velocity = 100, .corner = corner, .value = value});
  p.line({100, 0}, 1);
  if (side == 0) p.line({100, 100}, 2);
  // The arc begins upwards, perpendicular to the line: its center is to the left or to the right.
  if (side < 0)
    p.arc(arc_about({100, 0}, {50, 0}, {50, 50}, Plane{0, 1}, ArcRotation::counterclockwise), 2);
  if (side > 0)
    p.arc(arc_about({100, 0}, {150, 0}, {150, 50}, Plane{0, 1}, ArcRotation::clockwise), 2);
  return p;
}

TEST(Blend, TrimsOfALineAndAnArc) {
  // Rows 10 and 11: deviation 1, quintic.
  const struct {
    int side;
    double trim, curvature;
  } rows[] = {{-1, 3.770703, 0.585375}, {1, 3.770698, 0.541158}};
  for (const auto& row : rows) {
    const Plan rounded = plan(joint(Corner::deviation, 1, row.side), usual(2, 1e6));
    const auto corners = rounded.corners();
    ASSERT_EQ(corners.size(), 1u);
    EXPECT_FALSE(corners[0].stop);
    EXPECT_NEAR(corners[0].trim, row.trim, 5e-7);
    EXPECT_NEAR(corners[0].deviation, 1, 1e-9);
    EXPECT_LE(corners[0].one_sided, 1);
    EXPECT_NEAR(corners[0].curvature, row.curvature, 5e-7);
  }
}

TEST(Corner, ByDistanceCurvatureAndVelocity) {
  const auto corner = [](Corner mode, double value) {
    const Plan p = plan(joint(mode, value, 0), usual(2, 1e6));
    EXPECT_EQ(p.corners().size(), 1u);
    EXPECT_LE(path_tests::worst_ratio(to_axes(p), usual(2, 1e6)), 1 + 1e-12);
    return p.corners().front();
  };
  EXPECT_LE(corner(Corner::distance, 8).trim, 8);
  EXPECT_NEAR(corner(Corner::distance, 3).trim, 3, 1e-12);
  EXPECT_NEAR(corner(Corner::curvature, 0.4).curvature, 0.4, 1e-12);
  EXPECT_NEAR(corner(Corner::velocity, 40).velocity, 40, 1e-12);
  // A trim that the sides do not have.
  const CornerRecord tight = corner(Corner::curvature, 0.001);
  EXPECT_EQ(tight.note, JunctionNote::short_sides);
  EXPECT_LE(tight.trim, 50);
  EXPECT_GT(tight.curvature, 0.001);
  EXPECT_FALSE(tight.text.empty());
}

TEST(Corner, BlendsOfArcsByEveryMode) {
  const struct {
    Corner mode;
    double value;
  } rows[] = {{Corner::deviation, 0.5},
              {Corner::distance, 3},
              {Corner::curvature, 0.5},
              {Corner::velocity, 20}};
  for (const int side : {-1, 1})
    for (const auto& [mode, value] : rows) {
      const GroupLimits limits = usual(2, 1e6);
      const Program p = joint(mode, value, side);
      const Plan rounded = plan(p, limits);
      const CornerRecord c = rounded.corners().front();
      EXPECT_EQ(c.note, JunctionNote::none);
      if (mode == Corner::deviation) {
        EXPECT_LE(c.deviation, value);
      }
      if (mode == Corner::distance) {
        EXPECT_NEAR(c.trim, value, 1e-12);
      }
      if (mode == Corner::curvature) {
        EXPECT_LE(c.curvature, value * (1 + 1e-9));
      }
      if (mode == Corner::velocity) {
        EXPECT_NEAR(c.velocity, value, 1e-9);
      }
      const PlanAxes axes = to_axes(rounded, 1e-9);
      path_tests::expect_whole(rounded, axes, p);
    }
}

TEST(Corner, ATangentJointStepsOrIsRounded) {
  const auto tangent_joint = [](Corner mode) {
    Program p(2);
    p.set({.velocity = 50, .corner = mode, .value = 0.1});
    p.line({100, 0}, 1);
    p.arc(arc_about({100, 0}, {100, 50}, {150, 50}, Plane{0, 1}, ArcRotation::counterclockwise), 2);
    return p;
  };
  const Plan steps = plan(tangent_joint(Corner::stop), usual(2));
  ASSERT_EQ(steps.corners().size(), 1u);
  EXPECT_EQ(steps.corners()[0].note, JunctionNote::steps);
  EXPECT_FALSE(steps.corners()[0].stop);
  EXPECT_NEAR(steps.corners()[0].velocity, 50, 1e-9);
  const Program smooth = tangent_joint(Corner::deviation);
  const Plan rounded = plan(smooth, usual(2));
  ASSERT_EQ(rounded.corners().size(), 1u);
  EXPECT_EQ(rounded.corners()[0].note, JunctionNote::none);
  // A step of v^2 / R within the jerk limit takes v / (J R) times v^2; a quintic a little longer.
  EXPECT_GT(rounded.corners()[0].trim, 50.0 * 50 * 50 / 50 / 1e4 / 2);
  EXPECT_GT(rounded.corners()[0].velocity, 0.97 * 50);
  const PlanAxes axes = to_axes(rounded, 1e-10);
  for (const Trajectory& f : axes.curves) EXPECT_LE(std::abs(largest_jump(f, 2).step), 1e-3);
}

TEST(Corner, AReversalRests) {
  Program p(2);
  p.set({.velocity = 50, .corner = Corner::deviation, .value = 0.1});
  p.line({100, 0}, 1);
  p.line({50, 0}, 2);
  const Plan back = plan(p, usual(2));
  ASSERT_EQ(back.corners().size(), 1u);
  EXPECT_TRUE(back.corners()[0].stop);
  EXPECT_EQ(back.corners()[0].note, JunctionNote::turns_back);
}

TEST(Corner, CommandsWithoutDistanceAreLeftOutAndReported) {
  Program p(2);
  p.set({.velocity = 50});
  p.line({100, 0}, 1);
  p.line({100, 0}, 2);
  p.line({200, 0}, 3);
  const Plan plan_of = plan(p, usual(2));
  ASSERT_EQ(plan_of.corners().size(), 1u);
  EXPECT_EQ(plan_of.corners()[0].line, 2);
  EXPECT_EQ(plan_of.corners()[0].note, JunctionNote::no_distance);
}

/// The lines from place `first` to place `last` of a curve, of about 0.01 to 0.02 mm.
Point on_curve(int k) {
  return {80 * std::sin(2.5e-4 * k), 60 * std::sin(1.9e-4 * k)};
}

Program dense_lines(int first, int last) {
  Program p(2, on_curve(first));
  p.set({.velocity = 100, .corner = Corner::deviation, .value = 0.002});
  for (int k = first + 1; k <= last; ++k) p.line(on_curve(k), k);
  return p;
}

GroupLimits dense_limits() {
  return {.axes = std::vector<Limits>(2, {.velocity = 200, .acceleration = 2000, .jerk = 1e5})};
}

/// The time in which a point passes the curve if each turn takes half of both sides, with its greatest constant
/// velocity, and the velocity may step between the turns. The share b of a turn is 1/2 (docs/path/README.md, "Turns").
double time_of_turns(int first, int last) {
  double time = 0;
  for (int k = first + 1; k < last; ++k) {
    const Point a = on_curve(k - 1);
    const Point b = on_curve(k);
    const Point c = on_curve(k + 1);
    const double before = std::hypot(b[0] - a[0], b[1] - a[1]);
    const double behind = std::hypot(c[0] - b[0], c[1] - b[1]);
    const double length = (before + behind) / 2;
    double v = 100;
    for (std::size_t i = 0; i < 2; ++i) {
      const double bend = std::abs((c[i] - b[i]) / behind - (b[i] - a[i]) / before);
      v = std::min({v, std::cbrt(1e5 * length * length / (4 * bend)),
                    std::sqrt(2000 * length / (2 * bend))});
    }
    time += length / v;
  }
  return time;
}

TEST(Corner, TurnsThatShareTheirSidesChangeTheVelocity) {
  // All turns of a chain had the velocity of the slowest: 189.8 s, where the turns permit 8.2 s.
  constexpr int count = 20000;
  const Plan all = plan(dense_lines(0, count), dense_limits());
  EXPECT_LE(all.duration(), 2 * time_of_turns(0, count)) << "half as fast as the turns permit";
  double parts = 0;
  for (int k = 0; k < count; k += 1000)
    parts += plan(dense_lines(k, k + 1000), dense_limits()).duration();
  EXPECT_LE(all.duration(), parts) << "rests do not help";
  for (const CornerRecord& corner : all.corners()) EXPECT_LE(corner.deviation, 0.002 * (1 + 1e-12));
  EXPECT_TRUE(check_along(all).ok());
}

TEST(Corner, EqualTurnsKeepTheirVelocity) {
  Program p(2);
  p.set({.velocity = 100, .corner = Corner::deviation, .value = 0.5});
  for (int k = 1; k <= 12; ++k) p.line({2.0 * ((k + 1) / 2), 2.0 * (k / 2)}, k);  // a staircase
  // b = 1/2, l = 2 and |D_i| = 1: v^3 = J / 4 l^2. The ramp from a stop reaches it on the first half of a line.
  for (const CornerRecord& corner : plan(p, usual(2)).corners())
    EXPECT_NEAR(corner.velocity, std::cbrt(1e4), 1e-9);
}

TEST(Corner, ALawThatChangesTheVelocityInTurnsKeepsTheLimits) {
  const Program p = dense_lines(4000, 6000);
  const Plan all = plan(p, dense_limits());
  path_tests::expect_whole(all, to_axes(all, 1e-9), p);
  const Plan held = halted(all, all.duration() / 2);
  const double rest = held.law().at(held.duration()).position;
  EXPECT_GT(rest, all.law().at(all.duration() / 2).position);
  EXPECT_LT(rest, 0.9 * all.path().length()) << "the motion need not pass all turns";
  for (const Plan* const made : {&all, &held}) {
    const PlanAxes axes = to_axes(*made, 1e-9);
    for (std::size_t i = 0; i < 2; ++i) {
      const Ranges peaks = extrema(axes.curves[i]);
      EXPECT_LE(std::abs(peaks[2].peak().value), 2000 * (1 + 1e-12));
      EXPECT_LE(std::abs(peaks[3].peak().value), 1e5 * (1 + 1e-12));
    }
  }
}

}  // namespace
}  // namespace jounce::corner_test
