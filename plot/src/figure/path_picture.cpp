// SPDX-License-Identifier: Apache-2.0
#include "jounce/plot/path_picture.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "jounce/base/listed.hpp"
#include "jounce/base/units.hpp"
#include "jounce/design/path_cost.hpp"
#include "jounce/path/plan.hpp"

namespace jounce {
namespace {

constexpr int points_a_segment = 8;
constexpr double angle_a_point = 0.05;  // rad, on an arc
constexpr std::size_t marked_places = 5;

[[noreturn]] void fail(const std::string& plane, const std::string& rule) {
  throw InputError("plane", plane, rule);
}

std::size_t axis_named(const std::vector<Input>& axes, const std::string& name,
                       const std::string& plane) {
  const auto at = std::find_if(axes.begin(), axes.end(),
                               [&](const Input& input) { return input.axis == name; });
  if (at == axes.end())
    fail(plane,
         "must be the names of two axes of the path, separated by a comma, such as x,y: its axes "
         "are " +
             listed(axes, &Input::axis));
  return static_cast<std::size_t>(at - axes.begin());
}

int points_of(const Segment& segment) {
  double angle = 0;
  for (int k = 0; k < segment.sines; ++k)
    angle = std::max(angle, std::abs(segment.sine[static_cast<std::size_t>(k)].angle));
  return std::max(points_a_segment, static_cast<int>(std::min(angle / angle_a_point, 1e5)));
}

/// The breaks of all axes, and places between them where an axis bends.
std::vector<double> times_of(const std::vector<const Trajectory*>& curves) {
  std::vector<double> times;
  for (const Trajectory* curve : curves)
    for (std::size_t i = 0; i < curve->segments().size(); ++i) {
      const int points = points_of(curve->segments()[i]);
      for (int k = 0; k < points; ++k)
        times.push_back(curve->breaks()[i] + curve->segments()[i].length * k / points);
    }
  times.push_back(curves.front()->end());
  std::sort(times.begin(), times.end());
  times.erase(std::unique(times.begin(), times.end()), times.end());
  return times;
}

void add_marks(const Plan& plan, std::size_t x, std::size_t y, PathFigure& figure) {
  std::vector<SpeedLoss> losses = cost_of(plan, plan.corners()).losses;
  std::stable_sort(losses.begin(), losses.end(),
                   [](const SpeedLoss& a, const SpeedLoss& b) { return a.loss > b.loss; });
  losses.resize(std::min(losses.size(), marked_places));
  std::vector<Motion> axes(plan.path().axes());
  for (const SpeedLoss& loss : losses) {
    plan.at(std::min(loss.time, plan.duration()), axes);
    figure.marks.push_back({axes[x].position, axes[y].position,
                            (loss.cause == LossCause::start || loss.cause == LossCause::end)
                                ? name(loss.cause)
                                : "line " + std::to_string(loss.line)});
  }
}

PathFigure empty_figure(const Spec& spec, const std::string& x, const std::string& y,
                        const Units& units) {
  return {.title = spec.name,
          .x_label = x + " [" + units.position + "]",
          .y_label = y + " [" + units.position + "]",
          .speed_label = "speed [" + rate_unit(units.position, units.x, 1) + "]"};
}

}  // namespace

PathFigure path_figure(const std::vector<Input>& axes, const std::string& plane) {
  if (axes.front().overlap)
    fail(plane,
         "is not possible for lines that overlap in time: leave out --plane, or overlap of [path]");
  if (!axes.front().plan) fail(plane, "needs a spec of kind \"path\" or a G-code program");
  const Plan& plan = *axes.front().plan;
  const auto comma = plane.find(',');
  const std::size_t x = axis_named(axes, plane.substr(0, comma), plane);
  const std::size_t y =
      axis_named(axes, comma == std::string::npos ? "" : plane.substr(comma + 1), plane);
  const Units& units = axes[x].labels.units;
  if (axes[y].labels.units.position != units.position || x == y)
    fail(plane, "must name two different axes with the same unit");
  std::vector<const Trajectory*> curves;
  for (const Input& input : axes) curves.push_back(&std::get<Trajectory>(*input.curve));
  PathFigure figure = empty_figure(*axes.front().spec, axes[x].axis, axes[y].axis, units);
  for (const double t : times_of(curves)) {
    figure.x.push_back(curves[x]->at(t).position);
    figure.y.push_back(curves[y]->at(t).position);
    double square = 0;
    for (std::size_t i = 0; i < plan.given().path_axes; ++i)
      square += std::pow(curves[i]->at(t).velocity, 2);
    figure.speed.push_back(std::sqrt(square));
  }
  add_marks(plan, x, y, figure);
  return figure;
}

std::optional<PathFigure> path_figure(const Input& axis) {
  constexpr int instants = 2000;
  if (!axis.plan || axis.spec->axes.size() < 2) return std::nullopt;
  const Plan& plan = *axis.plan;
  PathFigure figure =
      empty_figure(*axis.spec, axis.spec->axes[0].name, axis.spec->axes[1].name, axis.spec->units);
  std::vector<Motion> axes(plan.path().axes());
  for (int k = 0; k <= instants; ++k) {
    plan.at(plan.duration() * k / instants, axes);
    double square = 0;
    for (std::size_t i = 0; i < plan.given().path_axes; ++i)
      square += std::pow(axes[i].velocity, 2);
    figure.x.push_back(axes[0].position);
    figure.y.push_back(axes[1].position);
    figure.speed.push_back(std::sqrt(square));
  }
  add_marks(plan, 0, 1, figure);
  return figure;
}

}  // namespace jounce
