// SPDX-License-Identifier: Apache-2.0
// Tables over time: PVT and PT.
#include <algorithm>
#include <array>
#include <span>
#include <string>
#include <variant>

#include <fmt/format.h>

#include "jounce/spec/spec.hpp"

#include "edit/src/kinds/kinds.hpp"

namespace jounce::edit_detail {
namespace {

/// The places of the neighbors between which point i of a list moves; null: there is none.
Json between(std::span<const double> x, std::size_t i) {
  return Json::array({i > 0 ? Json(x[i - 1]) : Json(), i + 1 < x.size() ? Json(x[i + 1]) : Json()});
}

Json remove_of(const std::string& row) {
  return {{"do", "remove"}, {"row", row}};
}

}  // namespace

void add_knots(Editable& editable) {
  const auto* table = std::get_if<Table>(&editable.spec().subject);
  if (table == nullptr) return;
  editable.add_points({"knot", "Knots", "knot", {"time", "position", "velocity", "acceleration"}});
  const std::vector<double>& x = table->columns().x;
  if (editable.count("knot") != x.size()) return;  // in another file
  const bool timed = editable.find("knot[1].time") != nullptr;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const std::string row = fmt::format("knot[{}]", i + 1);
    const std::string label = fmt::format("knot {}", i + 1);
    const auto on_curve = [&](const char* key) {
      return editable.coordinate(std::nullopt, row + key);
    };
    Json& handle =
        editable.add_handle(label, 0, 0, editable.coordinate(x[i], row + ".time"),
                            editable.coordinate(table->columns().p[i], row + ".position"));
    handle["between"] = between(x, i);
    if (x.size() > 2) handle["remove"] = remove_of(row);
    if (editable.can_have(row + ".velocity")) {
      handle["slope"] = {{"change", numbers_change()}, {"key", row + ".velocity"}};
      editable.add_handle(label, 0, 1, Editable::fixed(x[i]), on_curve(".velocity"));
    }
    if (editable.can_have(row + ".acceleration"))
      editable.add_handle(label, 0, 2, Editable::fixed(x[i]), on_curve(".acceleration"));
  }
  if (timed) editable.permit_insert();
}

namespace {

void add_pt(Editable& editable, const PtSpec& pt) {
  std::vector<double> x;
  for (const PtPoint& point : pt.points) x.push_back(point.x);
  const bool counts = editable.count("point") == x.size();  // false: in another file
  bool cumulative = true;
  for (std::size_t i = 0; counts && i < x.size(); ++i) {
    const std::string row = fmt::format("point[{}]", i + 1);
    Json& handle = editable.add_handle(
        fmt::format("point {}", i + 1), 0, 0, editable.coordinate(x[i], row + ".time"),
        editable.coordinate(pt.points[i].position, row + ".position"));
    handle["between"] = between(x, i);
    if (i == 0) handle["between"][0] = 0;
    if (x.size() > 1) handle["remove"] = remove_of(row);
    const TextNumber* time = editable.find(row + ".time");
    cumulative = cumulative && time != nullptr && time->value == x[i];
  }
  if (counts && cumulative) editable.permit_insert();
}

/// A point is the end of a stage: its place is the sum of the durations so far.
void add_stages(Editable& editable, const ProfileTableSpec& spec) {
  const auto& points = spec.table.points;
  if (editable.count("point") != points.size()) return;  // in another file
  static constexpr std::array keys{".position", ".velocity", ".acceleration"};
  const auto order = static_cast<std::size_t>(spec.quantity);
  const std::size_t most = std::min<std::size_t>(
      points.size(), static_cast<std::size_t>(spec.table.number_of_pairs.value_or(1 << 20)));
  double x = 0;
  for (std::size_t i = 0; i < most; ++i) {
    const double before = x;
    x += points[i].delta_time;
    const std::string row = fmt::format("point[{}]", i + 1);
    Json value = editable.coordinate(std::nullopt, row + keys[order]);
    if (spec.table.scale != 1) value["key"] = nullptr;
    Json& handle = editable.add_handle(fmt::format("point {}", i + 1), 0, order,
                                       editable.coordinate(x, row + ".delta_time"), value);
    handle["between"] = {before, nullptr};
    if (points.size() > 1) handle["remove"] = remove_of(row);
  }
}

}  // namespace

void add_time_table(Editable& editable) {
  const auto* table = std::get_if<TimeTableSpec>(&editable.spec().subject);
  if (table == nullptr) return;
  editable.add_points(
      {"point", "Points", "point", {"time", "delta_time", "position", "velocity", "acceleration"}});
  if (const auto* pt = std::get_if<PtSpec>(table))
    add_pt(editable, *pt);
  else
    add_stages(editable, std::get<ProfileTableSpec>(*table));
}

}  // namespace jounce::edit_detail
