// SPDX-License-Identifier: Apache-2.0
#include "axis/src/compensation/axis_coordinate.hpp"

#include <gtest/gtest.h>

#include "axis/bench.hpp"

namespace jounce::axis_coordinate_test {
namespace {

using namespace test;

/// The correction rises by 0.1 u from 0 to 100 u.
AxisConfig compensated() {
  AxisConfig config{.limits = limits(500, 5000)};
  config.compensation =
      AxisCompensation{.table = {.axes = {{0, 100, 2}}, .values = {0, 0.1}, .most = 1}, .own = 0};
  return resolved(config);
}

/// drive + offset = actual position + correction.
void expect_sum(const AxisCoordinate& at, double drive, double actual) {
  EXPECT_NEAR(drive + at.offset(), actual + at.correction()[0], 1e-12);
  EXPECT_NEAR(actual - drive, at.from_drive(), 1e-12);
}

TEST(AxisCoordinate, ANewCoordinateRenamesEveryPlace) {
  AxisCoordinate coordinate(resolved({.limits = limits(500, 5000)}));
  EXPECT_EQ(coordinate.actual(40, false), 40);
  coordinate.remember(1e-3, 41, 0, {.position = 40});
  coordinate.move_by(5);
  EXPECT_EQ(coordinate.offset(), 5);
  EXPECT_EQ(coordinate.commanded().before(0), 46);
  EXPECT_EQ(coordinate.actual_history().before(0), 45);
  const double actual = coordinate.actual(40, false);
  EXPECT_EQ(actual, 45);
  expect_sum(coordinate, 40, actual);
}

TEST(AxisCoordinate, SwitchingTheCompensationMovesNothing) {
  AxisCoordinate coordinate(compensated());
  double position = coordinate.actual(50, true);
  coordinate.remember(1e-3, position, 0, {.position = 50});
  EXPECT_FALSE(coordinate.compensates());
  position += coordinate.switch_compensation(true, position);
  EXPECT_TRUE(coordinate.compensates());
  EXPECT_NEAR(position, 50 / 1.001, 1e-9);
  EXPECT_NEAR(position + coordinate.correction()[0], 50, 1e-9) << "the drive stays";
  EXPECT_NEAR(coordinate.commanded().before(0), position, 1e-9);
  expect_sum(coordinate, 50, coordinate.actual(50, true));
  position += coordinate.switch_compensation(false, position);
  EXPECT_NEAR(position, 50, 1e-9);
}

TEST(AxisCoordinate, ADisabledAxisFollowsItsDriveThroughTheTable) {
  AxisCoordinate coordinate(compensated());
  coordinate.switch_compensation(true, coordinate.actual(0, true));
  EXPECT_NEAR(coordinate.actual(80, true), 80 / 1.001, 1e-9);
  EXPECT_NEAR(coordinate.actual(80, false), 80, 1e-9) << "the correction of the previous tick";
}

TEST(AxisCoordinate, TheCorrectionOfATickIsKeptForTheNextFeedback) {
  AxisCoordinate coordinate(compensated());
  coordinate.switch_compensation(true, coordinate.actual(0, true));
  References references{};
  references[0] = {60, 0, 0, 0};
  EXPECT_NEAR(coordinate.compensate(references)[0], 0.06, 1e-12);
  const double actual = coordinate.actual(60.06, false);
  EXPECT_NEAR(actual, 60, 1e-12);
  expect_sum(coordinate, 60.06, actual);
}

TEST(AxisCoordinate, RejectsASwitchThatChangesNothingOrPrecedesTheHoming) {
  AxisCoordinate coordinate(compensated());
  EXPECT_EQ(coordinate.against_switch(false, true)->cause, Cause::compensation_inactive);
  EXPECT_EQ(coordinate.against_switch(true, false)->cause, Cause::not_homed);
  EXPECT_FALSE(coordinate.against_switch(true, true));
  coordinate.switch_compensation(true, coordinate.actual(0, true));
  EXPECT_EQ(coordinate.against_switch(true, true)->cause, Cause::compensation_active);
}

}  // namespace
}  // namespace jounce::axis_coordinate_test
