// SPDX-License-Identifier: Apache-2.0
// The paths of the manuals, from their specs through a stream to a group of an executor. The log of
// each axis is compared with the plan of the spec, to the last bit.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>
#include <variant>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "jounce/design/input.hpp"
#include "jounce/machine/play_plan.hpp"
#include "jounce/profiles/curve/extrema.hpp"
#include "jounce/profiles/error.hpp"
#include "jounce/stream/sender/client.hpp"

#include "executor/site.hpp"
#include "support/errors.hpp"

namespace jounce::group_examples_test {
namespace {

using namespace std::chrono_literals;
using ::testing::HasSubstr;
namespace fs = std::filesystem;

const fs::path examples = fs::path(JOUNCE_SOURCE_DIR) / "examples";

std::vector<Input> read(const std::string& file) {
  return read_inputs((examples / file).string());
}

/// Limits of an axis that do not bind the path of a spec.
Limits wide(const Input& axis, const Trajectory& motion) {
  constexpr double reserve = 10;
  const Ranges ranges = extrema(motion);
  const auto limit = [&](int order, const std::optional<double>& given) {
    const double peak = std::abs(ranges[static_cast<std::size_t>(order)].peak().value);
    return reserve * std::max({peak, given.value_or(0), 1.0});
  };
  return {.velocity = limit(1, axis.limits.velocity),
          .acceleration = limit(2, axis.limits.acceleration)};
}

/// An axis for each axis of a path, and their group.
std::vector<ExecutorOptions> axes_for(const std::vector<Input>& path, const Point& start) {
  std::vector<ExecutorOptions> axes;
  ExecutorGroup group;
  const PlanAxes motions = to_axes(*path.front().plan);
  for (const Input& input : path) {
    ExecutorOptions axis = test::axis_named(input.axis, wide(input, motions.curves[axes.size()]),
                                            {"", input.table.units.position});
    axis.axis.position = start[axes.size()];
    group.of.axes.push_back(axes.size());
    group.names.push_back(input.axis);
    group.configs.push_back(axis.axis);
    axes.push_back(std::move(axis));
  }
  ExecutorOptions all = test::axis_named("group", {}, axes.front().units);
  all.axis = group_config(group.configs);
  all.enable = false;
  all.group = std::move(group);
  axes.push_back(std::move(all));
  return axes;
}

Point start_of(const Plan& plan) {
  std::vector<Motion> at(plan.path().axes());
  plan.at(0, at);
  Point start{};
  for (std::size_t k = 0; k < at.size(); ++k) start[k] = at[k].position;
  return start;
}

class GroupExamples : public testing::TestWithParam<const char*> {};

TEST_P(GroupExamples, ArePlayedAsPlanned) {
  const std::vector<Input> path = read(GetParam());
  const std::size_t n = path.size();
  const auto axes = axes_for(path, start_of(*path.front().plan));
  // Limits that do not bind may change the last bit of a plan.
  const auto& spec = std::get<PathSpec>(path.front().spec->subject);
  const Plan wanted = plan(spec.program, within(spec.limits, axes.back().group->configs));
  EXPECT_NEAR(wanted.duration(), path.front().plan->duration(), 1e-9);
  test::Site site(axes);
  site.advance(10ms);
  Client client(site.link, "group", {}, site.clock);
  ASSERT_TRUE(client.enable().ok());
  ASSERT_TRUE(client.release().ok());
  std::int64_t begin = -1;
  std::int64_t compared = 0;
  std::vector<Motion> at(n);
  site.after = [&] {
    const Tick& group = site.last(n);
    if (group.job == 0) return;
    if (begin < 0) begin = group.tick;
    const double t = static_cast<double>((group.tick - begin) * 1'000'000) / 1e9;
    wanted.at(t, at);
    for (std::size_t k = 0; k < n; ++k) {
      ASSERT_EQ(site.last(k).position, at[k].position) << path[k].axis << " at " << t;
      ASSERT_EQ(site.last(k).velocity, at[k].velocity) << path[k].axis << " at " << t;
      ASSERT_EQ(site.last(k).acceleration, at[k].acceleration) << path[k].axis << " at " << t;
    }
    ++compared;
  };
  const StreamOutcome outcome = site.stream(path_plan("group", path));
  ASSERT_TRUE(outcome.ok()) << outcome.reason;
  site.advance(std::chrono::milliseconds(static_cast<int>(wanted.duration() * 1000) + 100));
  EXPECT_EQ(site.last(n).finished, 1U);
  EXPECT_EQ(site.last(n).fault, Cause::none);
  EXPECT_EQ(compared, static_cast<std::int64_t>(std::ceil(wanted.duration() * 1000)));
  wanted.at(wanted.duration(), at);
  for (std::size_t k = 0; k < n; ++k) {
    EXPECT_EQ(site.last(k).position, at[k].position) << path[k].axis;
    EXPECT_EQ(site.last(k).state, State::standstill);
  }
}

INSTANTIATE_TEST_SUITE_P(OfTheManuals, GroupExamples,
                         testing::Values("himc-path/lines.toml", "himc-path/stadium.toml",
                                         "himc-path/square.toml", "himc-path/second-lap.toml",
                                         "himc-path/arc-corners.toml", "himc-path/helix.toml",
                                         "pmc600-path/lines.toml", "pmc600-path/arcs.toml",
                                         "pmc600-path/ellipse.toml", "pmc600-path/helix.toml",
                                         "pmc600-path/corners.toml", "pmc600-path/sequence.toml",
                                         "pmc600-path/gcode.toml", "pmc600-path/gcode-arcs.toml",
                                         "plotter/square.toml", "path-square/curvature.toml"));

TEST(GroupStream, IsRejectedWithItsReason) {
  const std::vector<Input> path = read("path-square/deviation.toml");
  auto axes = axes_for(path, {});
  axes[2].group->configs[1].limits.position_max = 99;
  axes[1].axis.limits.position_max = 99;
  test::Site site(axes);
  site.advance(10ms);
  Client client(site.link, "group", {}, site.clock);
  ASSERT_TRUE(client.enable().ok());
  ASSERT_TRUE(client.release().ok());
  EXPECT_THAT(site.stream(path_plan("group", path)).reason,
              HasSubstr("exceeds position_max of the axis, 99"));
  EXPECT_THAT(site.stream(path_plan("x", path)).reason, HasSubstr("not_a_group"));
  StreamPlan table = stream_plan("group", path.front(), {});
  EXPECT_THAT(site.stream(table).reason, HasSubstr("single_axis"));
  std::vector<Input> turned{path[1], path[0]};
  EXPECT_THAT(site.stream(path_plan("group", turned)).reason,
              HasSubstr("use the same names in the same order"));
  StreamPlan spoiled = path_plan("group", path);
  Columns columns = spoiled.tables.front().table.columns();
  columns.p[1] = 7;
  spoiled.tables.front().table =
      Table(Domain::master, Interpolation::linear, Extrapolation::hold, columns);
  EXPECT_FALSE(site.stream(spoiled).ok());
  EXPECT_EQ(site.last(2).state, State::standstill);
}

TEST(GroupStream, StartsOnlyWhereTheAxesStand) {
  const std::vector<Input> path = read("path-square/deviation.toml");
  test::Site site(axes_for(path, {0, 1}));
  site.advance(10ms);
  Client client(site.link, "group", {}, site.clock);
  ASSERT_TRUE(client.enable().ok());
  ASSERT_TRUE(client.release().ok());
  EXPECT_THAT(site.stream(path_plan("group", path)).reason,
              HasSubstr("y is at 1 mm instead of 0 mm"));
}

TEST(GroupStream, PathsThatAGroupCannotPlayAreNotSent) {
  EXPECT_THAT(test::error_of([] { path_plan("group", read("pmc600-path/ratio.toml")); }),
              HasSubstr("override"));
  EXPECT_THAT(test::error_of([] { path_plan("group", read("path-square/overlap.toml")); }),
              HasSubstr("overlap"));
  std::vector<Input> turned = read("plotter/square.toml");
  turned[1].table.units.position = "deg";
  EXPECT_THAT(test::error_of([&] { path_plan("group", turned); }),
              HasSubstr("y.unit = deg: must be mm"));
}

}  // namespace
}  // namespace jounce::group_examples_test
