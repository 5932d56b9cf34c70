// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "jounce/axis/axis.hpp"
#include "jounce/profiles/error.hpp"

#include "axis/tables.hpp"

namespace jounce::axis_compare_test {
namespace {

using namespace test;

const AxisConfig wide{.limits = limits(1e3, 1e5)};

PositionCompare every_millimeter() {
  return {.mode = CompareMode::linear, .points = evenly(1, 1, 20), .pulse = 2e-4};
}

struct Comparing : Bench {
  explicit Comparing(SwitchesOf of = SwitchesOf::position) : Bench(wide), drive(0) {
    axis = MotionAxis(wide, {}, {of, every_millimeter()});
  }
  Tick step_with(const Command& command = {}) {
    Inputs inputs;
    inputs.feedback.position = drive;
    const Tick now = axis.step(++tick, command, inputs);
    for (const OutputEdge& edge : now.compare.edges())
      edges.push_back({before + edge.time, edge.on});
    before = now.time;
    drive = now.position - now.offset - lag;
    return now;
  }
  double drive;
  double lag = 0;
  double before = -1e-3;
  std::vector<OutputEdge> edges;
};

// The edges of a table that is played are those of its curve, from the tick of its start on.
TEST(AxisCompare, FiresAtTheInstantsOfTheTableItPlays) {
  const TablePtr table = trapezoid_table(30, 100, 1000, 1000);
  Job job(1, table);
  Comparing axis;
  axis.step_with({command::Enable{}});
  axis.step_with({command::Arm{.movement = &job}});
  axis.step_with({command::Start{.tick = 40}});
  while (axis.tick < 500) axis.step_with();
  const auto exact = compared(every_millimeter(), table->curve<OverTime>()).edges;
  ASSERT_EQ(axis.edges.size(), exact.size());
  ASSERT_EQ(exact.size(), 40U);
  for (std::size_t i = 0; i < exact.size(); ++i) {
    EXPECT_NEAR(axis.edges[i].time, 0.04 + exact[i].time, 1e-11) << i;
    EXPECT_EQ(axis.edges[i].on, exact[i].on);
  }
}

TEST(AxisCompare, BeginsAnewWithEveryMotionFromRest) {
  Comparing axis;
  axis.step_with({command::Enable{}});
  axis.step_with({command::MoveAbsolute{.position = 30}});
  for (int i = 0; i < 500; ++i) axis.step_with();
  EXPECT_EQ(axis.edges.size(), 40U);
  axis.step_with({command::MoveAbsolute{.position = 0.5}});
  for (int i = 0; i < 500; ++i) axis.step_with();
  EXPECT_EQ(axis.edges.size(), 42U) << "on the way back it waits for the second point at the first";
  axis.step_with({command::MoveAbsolute{.position = 30}});
  for (int i = 0; i < 500; ++i) axis.step_with();
  EXPECT_EQ(axis.edges.size(), 82U);
}

// The drive is a tick and 0.25 u behind: so are its edges.
TEST(AxisCompare, StandsOnTheActualPositionWhereThatIsDeclared) {
  Comparing commanded, actual(SwitchesOf::actual);
  for (Comparing* axis : {&commanded, &actual}) {
    axis->lag = 0.25;
    axis->step_with({command::Enable{}});
    axis->step_with({command::MoveVelocity{.velocity = 100}});
    for (int i = 0; i < 180; ++i) axis->step_with();
  }
  ASSERT_GE(actual.edges.size(), 20U);
  for (std::size_t i = 4; i < actual.edges.size(); i += 2)
    EXPECT_NEAR(actual.edges[i].time - commanded.edges[i].time, 1e-3 + 0.25 / 100, 1e-9) << i;
}

TEST(AxisCompare, ANewCountPassesNothing) {
  Comparing axis;
  axis.step_with({command::Enable{}});
  axis.step_with({command::SetPosition{.position = 10}});
  for (int i = 0; i < 5; ++i) axis.step_with();
  EXPECT_TRUE(axis.edges.empty());
}

TEST(AxisCompare, IsNotOfAMaster) {
  EXPECT_THROW(MotionAxis(wide, {}, {SwitchesOf::master, every_millimeter()}), InputError);
}

}  // namespace
}  // namespace jounce::axis_compare_test
