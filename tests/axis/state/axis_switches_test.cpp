// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "jounce/axis/axis.hpp"
#include "jounce/cam/coupling/followed.hpp"
#include "jounce/profiles/error.hpp"

#include "axis/tables.hpp"

namespace jounce::axis_switches_test {
namespace {

using test::Bench;
using test::constant_master;
using test::limits;
using test::pmc600_cam;
using test::trapezoid_table;
using Kind = CommandKind;

CamSwitchSpec range(double first, double last, std::optional<double> period = {}) {
  return {.switches = {{.first_on_position = first, .last_on_position = last}},
          .tracks = {{.on_compensation = -0.002, .off_compensation = -0.002}},
          .period = period};
}

/// Plays the job and gives all edges, with times since its start.
std::vector<SwitchEdge> played(Bench& bench, Job& job) {
  bench.send(Kind::enable);
  bench.arm(job);
  std::vector<SwitchEdge> edges;
  const std::int64_t start = bench.tick + 1;
  for (Tick tick = bench.send(Kind::start); tick.job != 0; tick = bench.step())
    for (SwitchEdge edge : tick.switches.edges()) {
      edge.time += static_cast<double>(tick.tick - 1 - start) * 1e-3;
      edges.push_back(edge);
    }
  return edges;
}

void expect_same(const std::vector<SwitchEdge>& edges, const SwitchTimes& exact) {
  ASSERT_EQ(edges.size(), exact.edges.size());
  for (std::size_t i = 0; i < edges.size(); ++i) {
    EXPECT_EQ(edges[i].on, exact.edges[i].on);
    EXPECT_NEAR(edges[i].time, exact.edges[i].time, 1e-6);
  }
}

TEST(AxisSwitches, OfThePositionSwitchByTheTable) {
  const auto table = trapezoid_table(100, 500, 10000, 10000);
  Job job(1, table);
  Bench bench({.limits = limits(600, 11000)}, {.table = range(30.3, 80.8)});
  const auto edges = played(bench, job);
  EXPECT_EQ(edges.size(), 2U);
  expect_same(edges, switch_times(range(30.3, 80.8), table->curve<OverTime>()));
}

TEST(AxisSwitches, OfTheMasterAreNotOnBeforeThereIsOne) {
  Bench bench({.limits = limits(600, 11000)}, {.of = SwitchesOf::master, .table = range(-10, 10)});
  EXPECT_EQ(bench.step().switches.outputs, 0U) << "0 is in the range, but it is no master's";
  Job move(1, trapezoid_table(100, 500, 10000, 10000));
  EXPECT_TRUE(played(bench, move).empty()) << "a table over time has no master";
  EXPECT_EQ(bench.step().switches.outputs, 0U);
}

TEST(AxisSwitches, OfTheMasterSwitchInEachPeriod) {
  const auto master = constant_master(1080, 200);
  Job job(1, master, pmc600_cam());
  Bench bench({.limits = limits(700, 7000)},
              {.of = SwitchesOf::master, .table = range(350, 10, 360)});
  const auto edges = played(bench, job);
  expect_same(edges, switch_times(range(350, 10, 360), master->curve<OverTime>()));
  EXPECT_EQ(edges.size(), 6U);
}

TEST(AxisSwitches, StandThroughAFaultAndMoveWithANewPosition) {
  Bench bench({.limits = limits(600, 11000), .position = 50},
              {.table = {.switches = {{.first_on_position = 40, .last_on_position = 60}}}});
  EXPECT_EQ(bench.step().switches.outputs, 1U);
  bench.send(Kind::enable);
  EXPECT_EQ(bench.send(Kind::abort).switches.outputs, 1U);
  bench.send(Kind::reset);
  const Tick moved = bench.step({command::SetPosition{.position = 0}});
  EXPECT_EQ(moved.switches.outputs, 0U);
  ASSERT_EQ(moved.switches.count, 1U);
  EXPECT_EQ(moved.switches.edge[0].time, 0);
  const Tick beyond = bench.step({command::SetPosition{.position = 100}});
  EXPECT_EQ(beyond.switches.count, 0U);  // 40 to 60 was not passed
}

TEST(AxisSwitches, AnAxisWithoutAnyHasNoOutputs) {
  Bench bench({.limits = limits(600, 11000)});
  EXPECT_EQ(bench.step().switches.outputs, 0U);
}

TEST(AxisSwitches, ABadTableIsRejectedWithTheAxis) {
  EXPECT_THROW(MotionAxis({.limits = limits(1, 1)}, {.table = range(3, 2)}), InputError);
}

}  // namespace
}  // namespace jounce::axis_switches_test
