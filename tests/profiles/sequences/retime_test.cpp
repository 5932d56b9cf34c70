// SPDX-License-Identifier: Apache-2.0
#include "jounce/profiles/sequences/retime.hpp"

#include <array>
#include <vector>

#include <gtest/gtest.h>

#include "jounce/profiles/error.hpp"
#include "jounce/profiles/moves/s_curve.hpp"

#include "support/invariants.hpp"

namespace jounce::retime_test {
namespace {

TEST(Retime, TheRiseOfAQuinticTakesTheTimeOfItsCharacteristicValues) {
  // The 5th degree polynomial has C_v = 15/8, C_a = 10/sqrt(3), C_j = 60 (VDI 2143): over a second and
  // a height of 1 each limit alone asks for one stretch.
  const Trajectory rise({quintic(1, 0, 0, 0, 1, 0, 0)});
  EXPECT_NEAR(least_stretch(rise, {.velocity = 1.5}), 1.25, 1e-15);
  EXPECT_NEAR(least_stretch(rise, {.acceleration = 10 / std::sqrt(3) / 4}), 2, 1e-15);
  EXPECT_NEAR(least_stretch(rise, {.jerk = 60 * 8}), 0.5, 1e-15);
  EXPECT_NEAR(least_stretch(rise, {.velocity = 1.5, .acceleration = 100, .jerk = 480}), 1.25,
              1e-15);
}

TEST(Retime, TheResultMeetsALimitExactlyAndKeepsItsStart) {
  const Trajectory move =
      shifted(s_curve({.to = 50, .velocity = 10, .acceleration = 20, .jerk = 100}).curve(), 7);
  const Limits limits{.velocity = 3, .acceleration = 20, .jerk = 1};
  const Trajectory slow = retimed(move, limits);
  const Report report = check(slow, limits);
  EXPECT_TRUE(report.ok());
  EXPECT_NEAR(report.findings.front().margin, 0, 1e-14) << "no slower than it must be";
  EXPECT_NEAR(slow.start(), 7, 1e-14);
  EXPECT_NEAR(slow.at(slow.end()).position, 50, 1e-13);
  test::expect_invariants(slow, 2);
}

TEST(Retime, AxesThatGoTogetherTakeTheSlowest) {
  const std::array axes{Trajectory({cubic(1, 0, 0, 1, 0)}), Trajectory({cubic(1, 0, 0, 10, 0)})};
  const std::array<Limits, 2> limits{Limits{.velocity = 1.5}, Limits{.velocity = 5}};
  EXPECT_NEAR(least_stretch(axes, limits), 3, 1e-15);
}

TEST(Retime, PowersOfTwoOfTheUnitDoNotChangeABit) {
  const Trajectory move =
      s_curve({.to = 3, .velocity = 1.1, .acceleration = 7, .jerk = 90}).curve();
  const double k = least_stretch(move, {.velocity = 1, .acceleration = 3, .jerk = 50});
  const double big = 0x1p20;
  EXPECT_EQ(k, least_stretch(scaled(move, big),
                             {.velocity = big, .acceleration = 3 * big, .jerk = 50 * big}));
}

TEST(Retime, RejectsWhatNothingBounds) {
  const Trajectory move({cubic(1, 0, 0, 1, 0)});
  EXPECT_THROW(least_stretch(move, {}), InputError);
  EXPECT_THROW(least_stretch(Trajectory({line(1, 2, 2)}), {.velocity = 1}), InputError);
  EXPECT_THROW(least_stretch(move, {.velocity = -1}), InputError);
  const std::vector<Trajectory> two{move, move};
  const std::vector<Limits> one{{.velocity = 1}};
  EXPECT_THROW(least_stretch(two, one), InputError);
}

}  // namespace
}  // namespace jounce::retime_test
