// SPDX-License-Identifier: Apache-2.0
// Long programs of robots, which are planned in windows. The judge of every tick has the limits of the
// joints, the lines of the program, and the geometry of the robot in closed form; it shares no code
// with the maps and the planner.
#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "jounce/executor/detail/group_plan.hpp"
#include "jounce/path/axis_map.hpp"

#include "executor/group/sent_plotter.hpp"

namespace jounce::group_windows_maps_test {
namespace {

using namespace test;
using namespace std::chrono_literals;

using Place = std::array<double, 3>;
constexpr double degree = std::numbers::pi / 180;
constexpr double corner = 0.2;  // mm, deviation of the corners
constexpr double dt = 1e-3;

double distance_of(const Place& p, const Place& from, const Place& to) {
  double along = 0;
  double square = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    along += (p[i] - from[i]) * (to[i] - from[i]);
    square += (to[i] - from[i]) * (to[i] - from[i]);
  }
  const double t = square > 0 ? std::clamp(along / square, 0.0, 1.0) : 0;
  double away = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const double d = p[i] - from[i] - t * (to[i] - from[i]);
    away += d * d;
  }
  return std::sqrt(away);
}

/// A robot with three joints: its map for the executor, and its geometry for the judge.
struct Robot {
  std::shared_ptr<const AxisMap> map;
  std::vector<Limits> joints;
  /// Distance between these joints and the tool `p`, mm, by the geometry alone.
  double (*misfit)(const std::array<double, 3>& joints, const Place& p);
  Place center;
};

/// Arms of 300 and 250 mm, and a vertical axis.
double scara_misfit(const std::array<double, 3>& j, const Place& p) {
  const double first = j[0] * degree;
  const double second = first + j[1] * degree;
  return std::hypot(300 * std::cos(first) + 250 * std::cos(second) - p[0],
                    300 * std::sin(first) + 250 * std::sin(second) - p[1], j[2] - p[2]);
}

/// Three vertical rails: each arm of 320 mm keeps its length.
double delta_misfit(const std::array<double, 3>& j, const Place& p) {
  double most = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const double angle = (90 + 120 * static_cast<double>(i)) * degree;
    const double arm =
        std::hypot(p[0] - 160 * std::cos(angle), p[1] - 160 * std::sin(angle), p[2] - j[i]);
    most = std::max(most, std::abs(arm - 320));
  }
  return most;
}

Robot scara() {
  return {scara_map({.arms = {300, 250}, .with_z = true}),
          {limits(200, 1500, 30000), limits(300, 2500, 50000), limits(400, 4000, 80000)},
          scara_misfit,
          {330, 60, 20}};
}

Robot delta() {
  return {linear_delta_map({.outer_radius = 200, .inner_radius = 40, .arm = 320, .first_rail = 90}),
          std::vector<Limits>(3, limits(1200, 15000, 500000)),
          delta_misfit,
          {0, 0, 0}};
}

/// A wave about the center of the robot.
Program wave(const Robot& robot, int count) {
  const auto [cx, cy, cz] = robot.center;
  Program program(3, {cx, cy, cz});
  program.set({.velocity = 100, .corner = Corner::deviation, .value = corner});
  for (int k = 1; k <= count; ++k)
    program.line({cx + 40 * std::sin(0.031 * k) + 0.7 * std::sin(1.7 * k),
                  cy + 40 * std::sin(0.023 * k), cz + 10 * std::sin(0.017 * k)},
                 k);
  return program;
}

std::vector<ExecutorOptions> machine(const Robot& robot, const PlanWindow& window) {
  std::vector<ExecutorOptions> axes;
  ExecutorGroup group;
  group.window = window;
  std::array<Jet, 3> at{};
  std::array<Jet, 3> joints{};
  for (std::size_t i = 0; i < 3; ++i) at[i] = {robot.center[i], 0, 0, 0};
  EXPECT_EQ(robot.map->jets(at, joints), MapState::ok);
  for (std::size_t i = 0; i < 3; ++i) {
    axes.push_back(axis_named("j" + std::to_string(i), robot.joints[i]));
    axes.back().axis.position = joints[i][0];
    group.of.axes.push_back(i);
    group.names.push_back("j" + std::to_string(i));
    group.configs.push_back(axes.back().axis);
  }
  GroupKinematics kinematics;
  kinematics.names = {"x", "y", "z"};
  kinematics.path_axes = 3;
  kinematics.joints = {robot.map, robot.joints, 1e-6};
  kinematics.limits.axes = std::vector<Limits>(3, limits(2000, 1e6));
  group.kinematics = std::move(kinematics);
  ExecutorOptions all = axis_named("robot", {});
  all.axis = group_config(group.configs);
  all.enable = false;
  all.group = std::move(group);
  axes.push_back(std::move(all));
  return axes;
}

constexpr std::size_t robot_group = 3;

/// A robot that plays a program in windows, judged in every tick.
struct Judge {
  explicit Judge(Robot of)
      : robot(std::move(of)),
        site(machine(robot, {.commands = 120, .common = 60}), {.masters = {}, .recorded = true}) {
    site.advance(10ms);
    order(command::Enable{});
    site.after = [this] { judge(); };
  }
  void order(const ClientCommand& command) {
    Client client(site.link, "robot", {}, site.clock);
    const CallOutcome outcome = client.command(command);
    static_cast<void>(client.release());
    ASSERT_TRUE(outcome.ok()) << outcome.reason;
  }
  void stream(const Program& program) {
    sent = {program, {.axes = std::vector<Limits>(3, limits(2000, 1e6))}, {"x", "y", "z"}, {}};
    lines = {robot.center};
    for (std::size_t k = 1; k <= program.commands().size(); ++k) {
      const Point to = program.place_before(k);
      lines.push_back({to[0], to[1], to[2]});
    }
    whole = planned_program(program, sent.limits, *site.axes[robot_group].group);
    Columns columns;
    columns.p = numbers_of(sent);
    for (std::size_t k = 0; k < columns.p.size(); ++k) columns.x.push_back(static_cast<double>(k));
    StreamPlan plan;
    plan.executor = "robot";
    plan.mode = wire::ArmMode::path;
    plan.tables.push_back(
        {Table(Domain::master, Interpolation::linear, Extrapolation::hold, std::move(columns)),
         {}});
    const StreamOutcome outcome = site.stream(std::move(plan));
    ASSERT_TRUE(outcome.ok()) << outcome.reason;
  }
  /// The tool by the geometry: the place for which no arm has another length.
  [[nodiscard]] Place tool() const {
    std::array<double, 3> j{};
    for (std::size_t i = 0; i < 3; ++i) j[i] = site.last(i).position;
    return robot.misfit == scara_misfit ? scara_tool(j) : delta_tool(j);
  }
  static Place scara_tool(const std::array<double, 3>& j) {
    const double second = (j[0] + j[1]) * degree;
    return {300 * std::cos(j[0] * degree) + 250 * std::cos(second),
            300 * std::sin(j[0] * degree) + 250 * std::sin(second), j[2]};
  }
  /// Newton's method from the last place: the three arms keep their lengths.
  [[nodiscard]] Place delta_tool(const std::array<double, 3>& j) const {
    Place p = last_tool;
    for (int k = 0; k < 20; ++k) {
      std::array<std::array<double, 4>, 3>
          rows{};  // gradient of the square of each length, and its error
      for (std::size_t i = 0; i < 3; ++i) {
        const double angle = (90 + 120 * static_cast<double>(i)) * degree;
        const Place arm{p[0] - 160 * std::cos(angle), p[1] - 160 * std::sin(angle), p[2] - j[i]};
        double square = 0;
        for (std::size_t c = 0; c < 3; ++c) {
          rows[i][c] = 2 * arm[c];
          square += arm[c] * arm[c];
        }
        rows[i][3] = 320.0 * 320.0 - square;
      }
      const auto det = [&](std::size_t a, std::size_t b, std::size_t c) {
        const auto& [u, v, w] = rows;
        return u[a] * (v[b] * w[c] - v[c] * w[b]) - u[b] * (v[a] * w[c] - v[c] * w[a]) +
               u[c] * (v[a] * w[b] - v[b] * w[a]);
      };
      const double all = det(0, 1, 2);
      p[0] += det(3, 1, 2) / all;
      p[1] += det(0, 3, 2) / all;
      p[2] += det(0, 1, 3) / all;
    }
    return p;
  }
  void judge() {
    const Tick& all = site.last(robot_group);
    const bool full = all.rate == before[robot_group].rate;
    for (std::size_t i = 0; i < 3; ++i) {
      const Tick& joint = site.last(i);
      if (joint.tick == before[i].tick) continue;
      ASSERT_EQ(joint.fault, Cause::none);
      if (joint.state == State::synchronized_motion && before[i].state == joint.state) {
        ASSERT_TRUE(keeps_limits(resolved(site.axes[i].axis), before[i], joint, full))
            << "joint " << i << " in tick " << joint.tick;
      }
      before[i] = joint;
    }
    before[robot_group] = all;
    if (all.job == 0) return;
    if (std::find(movements.begin(), movements.end(), all.job) == movements.end())
      movements.push_back(all.job);
    last_tool = tool();
    double away = 1e9;
    for (std::size_t k = 1; k < lines.size(); ++k)
      away = std::min(away, distance_of(last_tool, lines[k - 1], lines[k]));
    ASSERT_LE(away, corner + 1e-5) << all.tick;
    ++ticks;
  }
  /// The group moves, or rests between two windows.
  [[nodiscard]] bool playing() { return site.last(robot_group).job != 0 || from_end() > 1e-5; }
  [[nodiscard]] double from_end() const {
    return robot.misfit({site.last(0).position, site.last(1).position, site.last(2).position},
                        lines.back());
  }
  /// Number of the windows that have begun.
  [[nodiscard]] std::size_t windows() const { return movements.size(); }
  void finish() {
    for (int k = 0; k < 600 && playing(); ++k) site.advance(100ms);
    EXPECT_EQ(site.last(robot_group).state, State::standstill);
    EXPECT_LT(from_end(), 1e-5);
  }

  Robot robot;
  Site site;
  LimitedProgram sent{Program(3), {}, {}, {}};
  std::vector<Place> lines;
  std::shared_ptr<const GroupProgram> whole;
  std::array<Tick, 4> before{};
  std::vector<std::uint64_t> movements;
  Place last_tool = robot.center;
  std::int64_t ticks = 0;
};

struct GroupWindowsOfRobots : ::testing::TestWithParam<Robot (*)()> {};

/// Two plans of fitted joints are not equal in their common commands, so the group rests between two
/// windows. The judge checks the tool and the joints in every
/// tick.
TEST_P(GroupWindowsOfRobots, KeepTheirPathAndLimits) {
  Judge test(GetParam()());
  test.stream(wave(test.robot, 300));
  test.finish();
  EXPECT_LE(test.windows(), 4U);
  EXPECT_LT(static_cast<double>(test.ticks) * dt, test.whole->plan->duration() * 1.03);
  const Replay replay = test.site.replayed();
  EXPECT_TRUE(replay.same()) << replay.shorter;
}

TEST_P(GroupWindowsOfRobots, HoldsAndOverridesAtTheBordersKeepTheLimits) {
  Judge test(GetParam()());
  test.stream(wave(test.robot, 300));
  std::size_t seen = 1;
  for (int k = 0; k < 4000 && test.playing(); ++k) {
    test.site.advance(20ms);
    if (test.windows() == seen) continue;
    seen = test.windows();  // the group has just changed to this window
    test.order(command::Override{seen % 2 == 0 ? 0.3 : 1.0});
    test.order(command::Hold{});
    test.site.advance(300ms);
    test.order(command::Resume{});
  }
  test.finish();
}

INSTANTIATE_TEST_SUITE_P(Of, GroupWindowsOfRobots, ::testing::Values(&scara, &delta),
                         [](const auto& each) { return each.index == 0 ? "Scara" : "Delta"; });

}  // namespace
}  // namespace jounce::group_windows_maps_test
