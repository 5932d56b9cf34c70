// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "executor/group/plotter_site.hpp"

// A plotter whose motion is judged in every tick. The judge has the limits of the axes and the
// requested lines and arcs, and nothing of the planner.
namespace jounce::test {

inline command::Coordinates at(double px, double py) {
  command::Coordinates to = command::no_coordinates<command::most_coordinates>();
  to[0] = px;
  to[1] = py;
  return to;
}

inline command::PathDynamics blending(double velocity, double deviation = as_configured) {
  return {
      .along = {.velocity = velocity}, .buffer = PathBuffer::look_ahead, .deviation = deviation};
}

/// The requested path: lines and circles, and the greatest distance that a corner may have from them.
struct Requested {
  struct Line {
    double x0, y0, x1, y1;
  };
  struct Circle {
    double x, y, r;
  };
  std::vector<Line> lines;
  std::vector<Circle> circles;
  double tolerance = 1e-9;

  [[nodiscard]] double distance(double px, double py) const {
    double least = std::numeric_limits<double>::infinity();
    for (const Line& l : lines) {
      const double dx = l.x1 - l.x0;
      const double dy = l.y1 - l.y0;
      const double square = dx * dx + dy * dy;
      const double along = square > 0 ? ((px - l.x0) * dx + (py - l.y0) * dy) / square : 0;
      const double t = std::clamp(along, 0.0, 1.0);
      least = std::min(least, std::hypot(px - l.x0 - t * dx, py - l.y0 - t * dy));
    }
    for (const Circle& c : circles)
      least = std::min(least, std::abs(std::hypot(px - c.x, py - c.y) - c.r));
    return least;
  }
};

/// A plotter whose axes are judged in every tick.
struct Judged : PlotterSite {
  explicit Judged(bool recorded = false, const Limits& axis = limits(200, 2000, 1e5),
                  const PlanWindow& window = {})
      : PlotterSite(recorded, axis, window), config(resolved(Plotter::config(axis))) {
    each_tick = [this] { judge(); };
    advance(std::chrono::milliseconds(10));
    EXPECT_TRUE(order("plotter", command::Enable{}).ok());
  }

  void judge() {
    const Tick& all = last(Plotter::group);
    moving += all.job != 0 && all.rate > 0;
    if (all.job == 0 && dispatcher.server(Plotter::group).status().queue_rows == 0) {
      rested = true;
      rest = {last(Plotter::x).position, last(Plotter::y).position};
    }
    const bool full = all.rate == before[Plotter::group].rate;  // it does not change
    for (const std::size_t i : {Plotter::x, Plotter::y}) {
      const Tick& axis = last(i);
      if (axis.tick == before[i].tick) continue;
      ASSERT_EQ(axis.fault, Cause::none) << axis.tick;
      if (axis.state == State::synchronized_motion && before[i].state == axis.state) {
        ASSERT_TRUE(keeps_limits(config, before[i], axis, full))
            << "axis " << i << " is beyond a limit in tick " << axis.tick << ": "
            << before[i].position << ' ' << before[i].velocity << ' ' << before[i].acceleration
            << " -> " << axis.position << ' ' << axis.velocity << ' ' << axis.acceleration;
      }
      before[i] = axis;
    }
    before[Plotter::group] = all;
    if (all.job != 0) {
      const double away = requested.distance(last(Plotter::x).position, last(Plotter::y).position);
      ASSERT_LE(away, requested.tolerance) << "off the path in tick " << all.tick;
    }
  }

  /// The start of the next command.
  [[nodiscard]] std::array<double, 2> from() const { return rested ? rest : end; }
  void accept(const std::array<double, 2>& to) {
    end = to;
    rested = false;
  }
  /// Sends a line; the request counts for the judge even before the answer.
  CallOutcome line(double px, double py, const command::PathDynamics& path) {
    const auto [x0, y0] = from();
    requested.lines.push_back({x0, y0, px, py});
    if (path.deviation > 0) requested.tolerance = std::max(requested.tolerance, path.deviation);
    const CallOutcome outcome = order("plotter", command::MoveLinearAbsolute{at(px, py), path});
    EXPECT_TRUE(outcome.ok() || outcome.error == StreamError::refused) << outcome.reason;
    if (outcome.ok()) accept({px, py});
    return outcome;
  }

  AxisConfig config;
  Requested requested;
  std::array<Tick, 3> before{};
  std::array<double, 2> rest{}, end{};
  bool rested = true;
  int moving = 0;
};

}  // namespace jounce::test
