// SPDX-License-Identifier: Apache-2.0
#include "plot/src/figure/path_points.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "plot/src/figure/ticks.hpp"

namespace jounce {
namespace {

constexpr double flatness = 1e-4;     // share of the size of the path
constexpr double near_points = 4e-4;  // share of the size: the speed between them is not visible
constexpr double speed_steps = 1.0 / 32;  // share of the greatest speed
constexpr int most_halvings = 14;         // each halves the time between two breaks
constexpr std::array quarters{0.25, 0.5, 0.75};

struct Allowed {
  double distance = 0, near = 0, speed = 0;
};

/// The distance of p from the line between a and b.
double distance(const DrawnPoint& p, const DrawnPoint& a, const DrawnPoint& b) {
  const double dx = b.x - a.x;
  const double dy = b.y - a.y;
  const double square = dx * dx + dy * dy;
  const double along =
      square > 0 ? std::clamp(((p.x - a.x) * dx + (p.y - a.y) * dy) / square, 0.0, 1.0) : 0;
  return std::hypot(p.x - a.x - along * dx, p.y - a.y - along * dy);
}

Allowed allowed_for(std::span<const DrawnPoint> points) {
  PlotRange x;
  PlotRange y;
  double fastest = 0;
  for (const DrawnPoint& p : points) {
    x.add(p.x);
    y.add(p.y);
    fastest = std::max(fastest, p.speed);
  }
  const double size = std::max(x.span(), y.span());
  return {flatness * size, near_points * size, speed_steps * fastest};
}

/// True if the line between a and b draws the path, which has the points `between` there.
bool is_drawn(const DrawnPoint& a, const DrawnPoint& b, std::span<const DrawnPoint> between,
              const Allowed& allowed) {
  PlotRange speed;
  speed.add(a.speed);
  speed.add(b.speed);
  for (const DrawnPoint& p : between) {
    if (distance(p, a, b) > allowed.distance) return false;
    speed.add(p.speed);
  }
  return speed.span() <= allowed.speed || std::hypot(b.x - a.x, b.y - a.y) <= allowed.near;
}

}  // namespace

std::vector<DrawnPoint> path_points(std::span<const double> breaks,
                                    const std::function<DrawnPoint(double)>& at) {
  std::vector<DrawnPoint> ends;
  for (const double t : breaks) ends.push_back(at(t));
  const Allowed allowed = allowed_for(ends);
  std::vector<DrawnPoint> points{ends.front()};
  struct Open {
    DrawnPoint end;
    int halvings = 0;
  };
  std::vector<Open> open;
  for (std::size_t i = 1; i < ends.size(); ++i) {
    open.push_back({ends[i]});
    while (!open.empty()) {
      const DrawnPoint& a = points.back();
      const Open next = open.back();
      std::array<DrawnPoint, quarters.size()> between;
      for (std::size_t k = 0; k < quarters.size(); ++k)
        between[k] = at(a.time + quarters[k] * (next.end.time - a.time));
      if (next.halvings == most_halvings || is_drawn(a, next.end, between, allowed)) {
        points.push_back(next.end);
        open.pop_back();
      } else {
        open.back().halvings = next.halvings + 1;
        open.push_back({between[1], next.halvings + 1});
      }
    }
  }
  return points;
}

}  // namespace jounce
