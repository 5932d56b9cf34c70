// SPDX-License-Identifier: Apache-2.0
#include "jounce/profiles/moves/explain.hpp"

#include <limits>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace jounce::explain_test {
namespace {

using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::StartsWith;

const Bounds bounds = within(10, 100, 1000);

/// The explanation of a move that must not exist.
std::string rejected(const MotionState& from, const MotionState& to, const Bounds& b = bounds) {
  const MoveResult move = move_to(from, to, b);
  EXPECT_FALSE(move);
  const std::string text = explain(move.status, from, to, b);
  EXPECT_THAT(text, StartsWith(explain(move.status)));
  return text;
}

std::string rejected(const MotionState& from, const MotionState& to, double duration) {
  const MoveResult move = move_to(from, to, bounds, duration);
  EXPECT_FALSE(move);
  return explain(move.status, from, to, bounds, duration);
}

TEST(Explain, NamesTheValueOfTheTargetAndItsBound) {
  EXPECT_THAT(rejected({}, {.position = 1, .velocity = 12}),
              EndsWith("bounds: velocity 12 is above the highest permitted value 10"));
  EXPECT_THAT(rejected({}, {.position = 1, .velocity = -11, .acceleration = 200}),
              EndsWith("bounds: velocity -11 is below the lowest permitted value -10, acceleration "
                       "200 is above the highest permitted value 100"));
}

// The acceleration 100 builds up over 0.1 s at jerk 1000, and so over 100^2 / 2000 = 5 of velocity.
TEST(Explain, NamesTheVelocityBeforeTheTarget) {
  EXPECT_THAT(rejected({}, {.position = 1, .velocity = -8, .acceleration = 100}),
              EndsWith("velocity -13 is below the lowest permitted value -10 before acceleration "
                       "100 at velocity -8"));
  EXPECT_THAT(rejected({}, {.position = 1, .velocity = 8, .acceleration = -100}),
              EndsWith("velocity 13 is above the highest permitted value 10 before acceleration "
                       "-100 at velocity 8"));
}

TEST(Explain, NamesThePositionLimits) {
  Bounds inside = bounds;
  inside.position_min = 0;
  inside.position_max = 5;
  EXPECT_THAT(rejected({}, {.position = 6}, inside),
              EndsWith("target 6 is above the highest permitted value 5"));
  EXPECT_THAT(
      rejected({.position = 4.99, .velocity = 9}, {.position = 3}, inside),
      EndsWith(
          "it begins at position 4.99 with velocity 9, ends at position 3 with velocity 0, and "
          "must stay above position 0 and below position 5"));
}

TEST(Explain, NamesWhatIsNotFiniteAndWhatIsNoBound) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(rejected({.velocity = nan}, {}), HasSubstr("start position 0, velocity nan"));
  EXPECT_THAT(rejected({}, {.position = 1}, within(-1, 100, 1000)), HasSubstr("velocity 1 to -1"));
  EXPECT_THAT(rejected({}, {.position = 1}, nan), EndsWith("duration nan"));
}

TEST(Explain, NamesThePossibleDurations) {
  const Durations all = durations({}, {.position = 1}, bounds);
  const std::string text = rejected({}, {.position = 1}, all.minimum / 2);
  EXPECT_THAT(text, HasSubstr("is given; possible durations are "));
  EXPECT_NEAR(std::stod(text.substr(text.find("durations are ") + 14)), all.minimum, 1e-12);
}

}  // namespace
}  // namespace jounce::explain_test
