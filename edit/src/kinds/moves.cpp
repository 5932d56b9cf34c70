// SPDX-License-Identifier: Apache-2.0
// Moves: single moves, queues, several axes from state to state, and through points.
#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <tuple>
#include <variant>

#include <fmt/format.h>

#include "jounce/spec/spec.hpp"

#include "edit/src/kinds/kinds.hpp"
#include "edit/src/kinds/passing.hpp"

namespace jounce::edit_detail {
namespace {

constexpr double same = 1e-6;  ///< share of the greatest position within which two are the same

/// The joints of all curves, in order.
std::vector<double> joints_of(const std::vector<const LazyCurve::Any*>& curves) {
  std::vector<double> all;
  for (const LazyCurve::Any* curve : curves)
    std::visit([&](const auto& f) { all.insert(all.end(), f.breaks().begin(), f.breaks().end()); },
               *curve);
  std::sort(all.begin(), all.end());
  return all;
}

Jet jet_at(const LazyCurve::Any& curve, double x) {
  return std::visit([&](const auto& f) { return f.jet(std::clamp(x, f.start(), f.end())); }, curve);
}

bool is_near(double a, double b) {
  return std::abs(a - b) <= same * std::max({1e-3, std::abs(a), std::abs(b)});
}

/// The states at both ends of an axis: `table` has from, to_velocity, and so on.
void add_ends(Editable& editable, const std::string& table, std::size_t axis) {
  if (axis >= editable.curves().size()) return;
  const LazyCurve::Any& curve = *editable.curves()[axis];
  static constexpr std::array suffixes{"", "_velocity", "_acceleration"};
  std::visit(
      [&](const auto& f) {
        for (const auto& [end, x, side] :
             {std::tuple{"from", f.start(), Side::right}, std::tuple{"to", f.end(), Side::left}})
          for (std::size_t order = 0; order < suffixes.size(); ++order) {
            const std::string key = fmt::format("{}.{}{}", table, end, suffixes[order]);
            const TextNumber* number = editable.find(key);
            const double place = f.jet(x, side)[order];
            if (!editable.can_have(key) || !is_near(number == nullptr ? 0 : number->value, place))
              continue;
            editable.add_handle(key, axis, order, Editable::fixed(x),
                                editable.coordinate(place, key));
          }
      },
      curve);
}

/// The targets of the commands of a queue, at the times at which the axis passes them.
void add_queue(Editable& editable) {
  std::vector<std::vector<double>> targets;
  std::vector<std::string> keys;
  const TextNumber* start = editable.find("start.position");
  double at = start != nullptr ? start->value : 0;
  for (std::size_t i = 0; i < editable.count("command"); ++i) {
    const std::string row = fmt::format("command[{}]", i + 1);
    const TextNumber* position = editable.find(row + ".position");
    const TextNumber* distance = editable.find(row + ".distance");
    if (position == nullptr && distance == nullptr) continue;
    at = position != nullptr ? position->value : at + distance->value;
    targets.push_back({at});
    keys.push_back(row + (position != nullptr ? ".position" : ".distance"));
  }
  const std::vector<double> times = passing_times(editable.curves(), targets);
  for (std::size_t i = 0; i < times.size(); ++i)
    editable.add_handle(keys[i], 0, 0, Editable::fixed(times[i]),
                        editable.coordinate(targets[i][0], keys[i]));
}

/// The points of a motion of several axes: in the pictures of the axes, and in their plane.
void add_via(Editable& editable, const AxesSpec& spec) {
  std::vector<std::string> columns;
  std::vector<std::string> heads;
  for (std::size_t a = 0; a < spec.axes.size(); ++a) {
    columns.push_back(fmt::format("position[{}]", a + 1));
    heads.push_back(editable.spec().axes[a].name);
  }
  editable.add_points({"point", "Points", "point", columns, heads});
  const std::vector<double> times = passing_times(editable.curves(), spec.points);
  for (std::size_t i = 0; i < spec.points.size(); ++i) {
    const std::string row = fmt::format("point[{}]", i + 1);
    const std::string label = fmt::format("point {}", i + 1);
    const Json remove =
        spec.points.size() > 2 ? Json{{"do", "remove"}, {"row", row}} : Json(nullptr);
    Json at = Json::array();
    for (std::size_t a = 0; a < columns.size(); ++a) {
      at.push_back(editable.coordinate(spec.points[i][a], row + "." + columns[a]));
      if (i < times.size())
        editable.add_handle(label, a, 0, Editable::fixed(times[i]), at.back())["remove"] = remove;
    }
    if (columns.size() > 1) editable.add_plane_handle(label, std::move(at))["remove"] = remove;
  }
  editable.permit_insert();
  if (columns.size() > 1) editable.permit_plane_insert();
}

}  // namespace

std::vector<double> passing_times(const std::vector<const LazyCurve::Any*>& curves,
                                  const std::vector<std::vector<double>>& points) {
  const std::vector<double> joints = joints_of(curves);
  std::vector<double> times;
  std::size_t j = 0;
  for (const std::vector<double>& point : points) {
    const auto passes = [&](double x) {
      for (std::size_t a = 0; a < curves.size(); ++a)
        if (!is_near(position_at(*curves[a], x), point[a])) return false;
      return true;
    };
    while (j < joints.size() && !passes(joints[j])) ++j;
    if (j == joints.size()) break;
    times.push_back(joints[j]);
  }
  return times;
}

double position_at(const LazyCurve::Any& curve, double x) {
  return jet_at(curve, x)[0];
}

void add_moves(Editable& editable) {
  const auto& subject = editable.spec().subject;
  if (std::holds_alternative<MoveSpec>(subject)) add_ends(editable, "move", 0);
  if (std::holds_alternative<QueueSpec>(subject)) add_queue(editable);
  const auto* axes = std::get_if<AxesSpec>(&subject);
  if (axes == nullptr) return;
  if (!axes->points.empty()) return add_via(editable, *axes);
  for (std::size_t a = 0; a < axes->axes.size(); ++a)
    add_ends(editable, fmt::format("axis[{}]", a + 1), a);
}

}  // namespace jounce::edit_detail
