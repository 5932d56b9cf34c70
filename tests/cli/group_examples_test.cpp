// SPDX-License-Identifier: Apache-2.0
// The paths of the manuals, from their specs through a stream to a group of an executor. The log of
// each axis is compared with the plan of the spec, to the last bit.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <ostream>
#include <string>
#include <utility>
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
  const Program& program = std::get<PathSpec>(path.front().spec->subject).program;
  group.followers = program.axes() - program.path_axes();
  group.unit = path.front().table.units.position;
  for (const Input& input : path) {
    ExecutorOptions axis = test::axis_named(input.axis, wide(input, motions.curves[axes.size()]),
                                            {"", input.table.units.position});
    axis.axis.position = start[axes.size()];
    group.of.axes.push_back(axes.size());
    group.names.push_back(input.axis);
    group.configs.push_back(axis.axis);
    group.units.push_back(input.table.units.position);
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

/// A spec, and its duration in s by the closed forms of its comment; 0: no closed form.
struct Example {
  const char* file;
  double duration = 0;
};
void PrintTo(const Example& example, std::ostream* to) {
  *to << example.file;
}

class GroupExamples : public testing::TestWithParam<Example> {};

TEST_P(GroupExamples, ArePlayedAsPlanned) {
  const std::vector<Input> path = read(GetParam().file);
  const std::size_t n = path.size();
  const auto axes = axes_for(path, start_of(*path.front().plan));
  // Limits that do not bind may change the last bit of a plan.
  const auto& spec = std::get<PathSpec>(path.front().spec->subject);
  const Plan wanted = plan(spec.program, within(spec.limits, axes.back().group->configs));
  EXPECT_NEAR(wanted.duration(), path.front().plan->duration(), 1e-9);
  const double expected = GetParam().duration > 0 ? GetParam().duration : wanted.duration();
  EXPECT_NEAR(wanted.duration(), expected, 2e-6);
  test::Site site(axes);
  site.advance(10ms);
  std::int64_t begin = -1;
  std::int64_t compared = 0;
  std::vector<Motion> at(n);
  Client client(site.link, "group", {}, site.clock);
  ASSERT_TRUE(client.enable().ok());
  ASSERT_TRUE(client.release().ok());
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

/// HIMC 8.1.6: Ex 1 lines, Ex 2 stadium, Ex 3-1 square, 3-2 second-lap, 3-3 arc-corners, Ex 4 helix (its
/// length 1573.976207 at 100 mm/s, and two ramps of 2 sqrt(100 / 25000) s), Ex 5 frame, work-frames.
/// PMC600: 8.1 lines, 8.3 arcs, 8.4 ellipse, 8.5 helix (110409.535 / 10000 + 10000 / 20000 s), 8.6 corners
/// and sequence, 8.8 gcode-arcs, 8.9 gcode; 7.3.1 blended-corner. 8.2 is below.
INSTANTIATE_TEST_SUITE_P(
    OfTheManuals, GroupExamples,
    testing::Values(Example{"himc-path/lines.toml", 2 * 1.540705},
                    Example{"himc-path/stadium.toml"}, Example{"himc-path/square.toml"},
                    Example{"himc-path/second-lap.toml"}, Example{"himc-path/arc-corners.toml"},
                    Example{"himc-path/helix.toml", 15.73976207 + 2 * std::sqrt(100 / 25000.0)},
                    Example{"himc-path/arc-forms.toml"}, Example{"himc-path/arc-speed.toml"},
                    Example{"himc-path/frame.toml"}, Example{"himc-path/work-frames.toml"},
                    Example{"pmc600-path/lines.toml", 2.5 + 2.870829},
                    Example{"pmc600-path/arcs.toml", 2.070796 + 3.641593},
                    Example{"pmc600-path/ellipse.toml", 2 * 1.918083},
                    Example{"pmc600-path/helix.toml", 11.0409535 + 0.5},
                    Example{"pmc600-path/corners.toml", 7.386350},
                    Example{"pmc600-path/sequence.toml"},
                    Example{"pmc600-path/gcode.toml", 1.514214 + 2.457023},
                    Example{"pmc600-path/gcode-arcs.toml", 6.055806},
                    Example{"pmc600-path/blended-corner.toml"}, Example{"plotter/square.toml"},
                    Example{"welding-head/seam.toml"}, Example{"path-square/curvature.toml"}));

/// PMC600 8.2: the live speed ratio. At the ratios 0.5, 1.5 and 1, the line of 5000 pulses has the printed
/// speeds 1500, 4500 and 3000.
TEST(GroupExamples, TheSpeedRatioIsLive) {
  std::vector<Input> path = read("pmc600-path/ratio.toml");
  auto& spec = std::get<PathSpec>(path.front().spec->subject);
  spec.override_steps.clear();
  const auto axes = axes_for(path, {});
  test::Site site(axes);
  site.advance(10ms);
  double farthest = 0;
  Client client(site.link, "group", {}, site.clock);
  ASSERT_TRUE(client.enable().ok());
  ASSERT_TRUE(client.command(command::Override{0.5}).ok());
  ASSERT_TRUE(client.release().ok());
  site.after = [&] {
    farthest = std::max(farthest, std::abs(site.last(0).position * 4 - site.last(1).position * 3));
  };
  StreamPlan line = path_plan("group", path);
  ASSERT_TRUE(site.stream(line).ok());
  const auto reaches = [&](double speed) {
    for (int k = 0; k < 2000; ++k) {
      site.advance(1ms);
      const double now = std::hypot(site.last(0).velocity, site.last(1).velocity);
      if (std::abs(now - speed) < 1e-6) return true;
    }
    return false;
  };
  EXPECT_TRUE(reaches(1500));
  for (const auto& [ratio, speed] : {std::pair{1.5, 4500.0}, {1.0, 3000.0}}) {
    ASSERT_TRUE(client.command(command::Override{ratio}).ok());
    ASSERT_TRUE(client.release().ok());
    EXPECT_TRUE(reaches(speed)) << ratio;
  }
  site.advance(3s);
  EXPECT_NEAR(site.last(0).position, 3000, 1e-9);
  EXPECT_NEAR(site.last(1).position, 4000, 1e-9);
  EXPECT_LT(farthest, 1e-8) << "off the line";
}

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
              HasSubstr("name the axes of the path as those of the group, in the same order"));
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
