// SPDX-License-Identifier: Apache-2.0
// The part of a straight line that a machine can pass, against closed forms of its kinematics.
#include "jounce/path/reach.hpp"

#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "tests/path/paths.hpp"

namespace jounce::reach_test {
namespace {

constexpr double degree = std::numbers::pi / 180;
constexpr double unlimited = std::numeric_limits<double>::infinity();
constexpr double a = 300;  // mm, the arms
constexpr double b = 250;

std::shared_ptr<const AxisMap> scara() {
  return scara_map({.arms = {a, b}});
}

Limits joint(double low, double high, double velocity) {
  return {.position_min = low, .position_max = high, .velocity = velocity};
}

/// Distance of the wrist from the base if the second joint has this angle, deg.
double radius_at(double elbow) {
  return std::sqrt(a * a + b * b + 2 * a * b * std::cos(elbow * degree));
}

TEST(Reach, ALineWithinAllRangesHasItsLength) {
  const std::vector<Limits> joints{joint(-130, 130, 200), joint(5, 155, 300)};
  const Reach all = reach(*scara(), joints, {400, 0}, {0, 1}, 100, 50);
  EXPECT_EQ(all.end, LineEnd::length);
  EXPECT_EQ(all.length, 100);
}

TEST(Reach, AJointEndsTheLineAtItsRange) {
  const std::vector<Limits> joints{joint(-130, 130, 200), joint(5, 155, 300)};
  const Reach out = reach(*scara(), joints, {300, 0}, {1, 0}, 1e6, 50);
  EXPECT_EQ(out.end, LineEnd::joint_limit);
  EXPECT_EQ(out.joint, 1U);
  EXPECT_EQ(out.limit, 5);
  EXPECT_LE(out.length, radius_at(5) - 300);
  EXPECT_NEAR(out.length, radius_at(5) - 300, 1e-7);
  const Reach in = reach(*scara(), joints, {300, 0}, {-1, 0}, 1e6, 50);
  EXPECT_EQ(in.end, LineEnd::joint_limit);
  EXPECT_EQ(in.limit, 155);
  EXPECT_NEAR(in.length, 300 - radius_at(155), 1e-7);
}

/// From the law of cosines, with e the angle of the second joint, r dr/de = -a b sin(e).
TEST(Reach, ALineEndsBeforeASingularPosition) {
  const std::vector<Limits> joints{joint(-180, 180, 1e6), joint(-180, 180, 300)};
  const Reach out = reach(*scara(), joints, {300, 0}, {1, 0}, 1e6, 50);
  EXPECT_EQ(out.end, LineEnd::singular);
  EXPECT_EQ(out.joint, 1U);
  const double r = 300 + out.length;
  const double e = std::acos((r * r - a * a - b * b) / (2 * a * b));
  const double velocity =
      300 * degree * a * b * std::sin(e) / r;  // velocity of the tool at 300 deg/s
  EXPECT_NEAR(velocity, singular_margin * 50, 1e-3 * singular_margin * 50);
  EXPECT_LT(r, a + b);
  // Twice the velocity ends farther from it.
  EXPECT_LT(reach(*scara(), joints, {300, 0}, {1, 0}, 1e6, 100).length, out.length);
  // The way back leads away from it.
  EXPECT_EQ(reach(*scara(), joints, {r, 0}, {-1, 0}, 100, 50).length, 100);
  EXPECT_LT(reach(*scara(), joints, {r, 0}, {1, 0}, 100, 50).length, 1e-6);
}

TEST(Reach, AStartAtTheEndOfARangeMayLeaveIt) {
  const std::vector<Limits> joints{joint(-130, 130, 200), joint(5, 155, 300)};
  const double r = radius_at(5);
  EXPECT_EQ(reach(*scara(), joints, {r, 0}, {-1, 0}, 100, 50).length, 100);
  EXPECT_LT(reach(*scara(), joints, {r, 0}, {1, 0}, 100, 50).length, 1e-6);
}

TEST(Reach, WithoutAVelocityTheStartDeterminesTheMargin) {
  const std::vector<Limits> joints{joint(-180, 180, 200), joint(-180, 180, 300)};
  const Reach out = reach(*scara(), joints, {300, 0}, {1, 0}, 1e6, unlimited);
  EXPECT_EQ(out.end, LineEnd::singular);
  EXPECT_NEAR(300 + out.length, a + b, 0.1);
}

TEST(Reach, JointsWithoutVelocityLimitsEndAtTheReach) {
  const std::vector<Limits> joints(2);
  const Reach out = reach(*scara(), joints, {300, 0}, {1, 0}, 1e6, 50);
  EXPECT_NE(out.end, LineEnd::length);
  EXPECT_NEAR(300 + out.length, a + b, 1e-6);
}

/// x + y reaches 100 first: from (10, 20), after 70 / sqrt(2).
TEST(Reach, ALinearMapEndsExactly) {
  const std::vector<Limits> joints{joint(-100, 100, 200), joint(-50, 50, 200)};
  const double half = std::sqrt(0.5);
  const Reach out = reach(*core_xy_map(2), joints, {10, 20}, {half, half}, 1e6, 50);
  EXPECT_EQ(out.end, LineEnd::joint_limit);
  EXPECT_EQ(out.joint, 0U);
  EXPECT_NEAR(out.length, 70 * half, 1e-7);
}

/// The height of a carriage over the tool is sqrt(arm^2 - distance^2).
TEST(Reach, ADeltaEndsAtTheRangeOfACarriage) {
  const auto delta =
      linear_delta_map({.outer_radius = 160, .inner_radius = 40, .arm = 320, .first_rail = 90});
  const std::vector<Limits> joints(3, joint(100, 450, 1200));
  const Reach up = reach(*delta, joints, {0, 0, 0}, {0, 0, 1}, 1e6, 300);
  EXPECT_EQ(up.end, LineEnd::joint_limit);
  EXPECT_NEAR(up.length, 450 - std::sqrt(320.0 * 320 - 120 * 120), 1e-7);
  const Reach aside = reach(*delta, joints, {0, 0, 0}, {1, 0, 0}, 1e6, 300);
  EXPECT_EQ(aside.end, LineEnd::joint_limit);
  EXPECT_EQ(aside.limit, 100);
}

/// No joint leaves its range on the part, and beyond it the first one does.
TEST(Reach, RandomLinesEndWithinTheRanges) {
  path_tests::Random random(27);
  const std::vector<Limits> joints{joint(-130, 130, 200), joint(5, 155, 300)};
  const auto map = scara();
  const auto inside = [&](double x, double y) {
    std::array<Jet, 2> out{};
    const std::array<Jet, 2> point{Jet{x, 0, 0, 0}, Jet{y, 0, 0, 0}};
    if (map->jets(point, out) != MapState::ok) return false;
    return std::abs(out[0][0]) <= 130 && out[1][0] >= 5 && out[1][0] <= 155;
  };
  int ends = 0;
  for (int n = 0; n < 300; ++n) {
    const double elbow = random.between(10, 150);
    const double turn = random.between(-120, 120) * degree;
    const double x = a * std::cos(turn) + b * std::cos(turn + elbow * degree);
    const double y = a * std::sin(turn) + b * std::sin(turn + elbow * degree);
    const double to = random.between(0, 2 * std::numbers::pi);
    const Reach one = reach(*map, joints, {x, y}, {std::cos(to), std::sin(to)}, 2000, 50);
    EXPECT_NE(one.end, LineEnd::length) << "the working area is smaller";
    for (int k = 0; k <= 100; ++k) {
      const double q = one.length * k / 100;
      ASSERT_TRUE(inside(x + q * std::cos(to), y + q * std::sin(to))) << n << ' ' << q;
    }
    if (one.end != LineEnd::joint_limit) continue;
    const double beyond = one.length + 1e-5;
    ++ends;
    ASSERT_FALSE(inside(x + beyond * std::cos(to), y + beyond * std::sin(to))) << n;
  }
  EXPECT_GT(ends, 250);
}

}  // namespace
}  // namespace jounce::reach_test
