// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <memory>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "jounce/axis/detail/group_path.hpp"
#include "jounce/axis/machine.hpp"
#include "jounce/path/arc.hpp"
#include "jounce/path/plan.hpp"

#include "axis/tables.hpp"

namespace jounce::test {

/// The contour of the tests, from the origin back to it: lines, and half a circle. It stops at every
/// joint, because no joint is tangent.
///
///        (0,60) _.-._ (80,60)
///             \       |
///     (0,0)---(30,0)  \---(100,0): from the origin along x, then counterclockwise
inline Program contour(double feed) {
  Program program(2);
  program.set({.velocity = feed});
  program.line({100, 0}, 1);
  program.line({80, 60}, 2);
  program.arc(
      arc_about(program.position(), {40, 60}, {0, 60}, Plane{0, 1}, ArcRotation::counterclockwise),
      3);
  program.line({30, 0}, 4);
  program.line({0, 0}, 5);
  return program;
}

/// The point of the contour at the length q, by its closed form: it shares no code with the path.
inline std::pair<double, double> contour_at(double q) {
  const auto on_line = [](double x0, double y0, double x1, double y1, double s) {
    const double length = std::hypot(x1 - x0, y1 - y0);
    return std::pair{x0 + (x1 - x0) * s / length, y0 + (y1 - y0) * s / length};
  };
  const double second = 100 + std::sqrt(4000.0);
  const double third = second + 40 * std::numbers::pi;
  const double fourth = third + std::sqrt(4500.0);
  if (q <= 100) return on_line(0, 0, 100, 0, q);
  if (q <= second) return on_line(100, 0, 80, 60, q - 100);
  if (q <= third) {
    const double angle = (q - second) / 40;
    return {40 + 40 * std::cos(angle), 60 + 40 * std::sin(angle)};
  }
  if (q <= fourth) return on_line(0, 60, 30, 0, q - third);
  return on_line(30, 0, 0, 0, q - fourth);
}

/// True if two successive ticks of an axis that follows its group keep the limits, by differences: at
/// full speed those of the axis, while the rate changes its stop limits.
inline bool keeps_limits(const AxisConfig& axis, const Tick& was, const Tick& now, bool full) {
  const double dt = 1e-3;
  const double a = full ? *axis.limits.acceleration : axis.stop_acceleration;
  const double j = full ? *axis.limits.jerk : axis.stop_jerk;
  constexpr double same = 1 + 1e-9;
  constexpr double rounding = 1e-9;
  return std::abs(now.position - was.position) <= *axis.limits.velocity * dt * same &&
         std::abs(now.acceleration) <= a * same &&
         std::abs(now.velocity - was.velocity) <= a * dt * same &&
         std::abs(now.acceleration - was.acceleration) <= j * dt * same + rounding;
}

/// A plotter: the axes x and y, and their group, which is stepped before them.
struct Plotter {
  static constexpr std::size_t x = 0, y = 1, group = 2;

  explicit Plotter(const Limits& axis = limits(200, 2000, 1e5),
                   const Program& commands = contour(150))
      : plan(std::make_shared<const Plan>(
            jounce::plan(commands, {.axes = std::vector<Limits>(commands.axes(), axis)}))),
        machine(axes_of(axis)),
        images(machine.size()),
        program(group_program(plan, std::vector<AxisConfig>(2, config(axis)),
                              std::vector<std::string>{"x", "y"})),
        path(7, program) {}

  static AxisConfig config(const Limits& axis) { return {.limits = axis}; }
  static std::vector<MachineAxis> axes_of(const Limits& axis) {
    const std::vector<AxisConfig> both(2, config(axis));
    return {{.name = "x", .config = both[0]},
            {.name = "y", .config = both[1]},
            {.name = "plotter", .config = group_config(both), .group = AxisGroup{{x, y}}}};
  }

  void step() {
    machine.step(++tick, images);
    for (AxisImage& image : images) image.command = {};
  }
  /// Steps with this command; returns the cause of its refusal.
  Cause send(std::size_t axis, const AxisCommand& command) {
    images[axis].command = {command};
    step();
    const auto& refused = images[axis].tick.refused;
    return refused ? refused->cause : Cause::none;
  }
  void steps(int count) {
    for (int i = 0; i < count; ++i) step();
  }
  void enable() {
    for (const std::size_t i : {x, y}) send(i, command::Enable{});
    send(group, command::Enable{});
  }
  void start() {
    enable();
    send(group, command::Arm{&path});
    send(group, command::Start{});
  }
  [[nodiscard]] const Tick& at(std::size_t axis) const { return images[axis].tick; }
  [[nodiscard]] bool moves() const { return at(group).job != 0 && at(group).rate != 0; }

  std::shared_ptr<const Plan> plan;
  Machine machine;
  std::vector<AxisImage> images;
  GroupProgram program;
  GroupPath path;
  std::int64_t tick = -1;
};

/// Short names of the axes of a plotter.
namespace on_plotter {

inline constexpr std::size_t x = Plotter::x;
inline constexpr std::size_t y = Plotter::y;
inline constexpr std::size_t group = Plotter::group;

}  // namespace on_plotter

}  // namespace jounce::test
