// SPDX-License-Identifier: Apache-2.0
#include <optional>
#include <string>
#include <variant>

#include <fmt/format.h>

#include "edit/src/cam_geometry.hpp"
#include "edit/src/kinds/kinds.hpp"

namespace jounce::edit_detail {
namespace {

constexpr std::size_t most_points = 500;  ///< a segment with more points is edited as text

/// A coordinate that fills in the member `key` of the change of its handle.
Json moving(std::optional<double> place, const char* key) {
  const Json at = place ? Json(*place) : Json();
  return {{"place", at}, {"key", key}, {"value", at}};
}

/// A number of a row; key "": it cannot be changed.
Json cell(const std::string& key, const Json& value) {
  return {{"key", key.empty() ? Json() : Json(key)}, {"value", value}};
}

void add_knot(Editable& editable, const CamSpec& cam, std::size_t k) {
  const CamKnot& knot = knot_of(cam, k);
  const std::size_t last = cam.segments.size();
  const std::string label = fmt::format("knot {}", k);
  const bool inner = k > 0 && k < last;
  Json x = moving(knot.master, "master");
  Json move{{"do", "move"}, {"knot", k}};
  if (!inner) {
    x = Editable::fixed(knot.master);
    move["master"] = knot.master;
  }
  Json& handle = editable.add_handle(label, 0, 0, std::move(x), moving(knot.slave, "slave"), move);
  if (inner) {
    handle["between"] = {knot_of(cam, k - 1).master, knot_of(cam, k + 1).master};
    handle["remove"] = {{"do", "merge"}, {"segment", k}};
  }
  const Settable settable = settable_at(cam, k);
  const auto set = [&](const char* key) { return Json{{"do", "set"}, {"knot", k}, {"key", key}}; };
  const Json on_curve{{"place", nullptr}, {"key", "value"}, {"value", nullptr}};
  if (settable.velocity) {
    handle["slope"] = {{"change", set("geo_velocity")}, {"key", "value"}};
    editable.add_handle(label, 0, 1, Editable::fixed(knot.master), on_curve, set("geo_velocity"));
  }
  if (settable.acceleration)
    editable.add_handle(label, 0, 2, Editable::fixed(knot.master), on_curve,
                        set("geo_acceleration"));
}

/// The points of a segment, if they are in the text, as handles and as rows.
void add_points_of(Editable& editable, const CamSpec& cam, std::size_t i, Json& rows) {
  const CamSegment& segment = cam.segments[i];
  const std::string list = fmt::format("segment[{}].points", i + 1);
  if (segment.points.size() > most_points || editable.count(list) == 0) return;
  const std::string of = fmt::format("segment {}", i + 1);
  for (std::size_t k = 0; k < segment.points.size(); ++k) {
    const CamPoint& point = segment.points[k];
    const std::string row = fmt::format("{}[{}]", list, k + 1);
    const Json remove = segment.points.size() > 1 ? Json{{"do", "remove"}, {"row", row}} : Json();
    Json change{{"do", "point"},
                {"segment", i + 1},
                {"point", k + 1},
                {"master", point.master},
                {"slave", point.slave.value_or(0)}};
    Json slave = point.slave ? moving(point.slave, "slave")
                             : Json{{"place", nullptr}, {"key", nullptr}, {"value", nullptr}};
    Json& handle = editable.add_handle(fmt::format("point {} of {}", k + 1, of), 0, 0,
                                       moving(point.master, "master"), slave, change);
    const double before = k == 0 ? knot_of(cam, i).master : segment.points[k - 1].master;
    const double after =
        k + 1 == segment.points.size() ? segment.end.master : segment.points[k + 1].master;
    handle["between"] = {before, after};
    handle["small"] = true;
    handle["remove"] = remove;
    rows.push_back(
        {{"label",
          fmt::format("{} of {}{}{}", k + 1, of, segment.name.empty() ? "" : " ", segment.name)},
         {"line", editable.line(row)},
         {"cells",
          {cell("master", point.master), cell(point.slave ? "slave" : "", slave["value"])}},
         {"change", change},
         {"remove", remove}});
  }
}

/// The switches that use the position of the master.
void add_switches(Editable& editable) {
  const AxisSwitches& switches = editable.spec().switches;
  if (switches.of != SwitchesOf::master || switches.table.switches.empty()) return;
  Json rows = Json::array();
  for (std::size_t i = 0; i < switches.table.switches.size(); ++i) {
    const CamSwitch& each = switches.table.switches[i];
    const auto& last = each.last_on_position;
    const Json change{{"do", "switch"},
                      {"switch", i + 1},
                      {"first", each.first_on_position},
                      {"last", last ? Json(*last) : Json()}};
    const std::string label = fmt::format("switch {}, track {}", i + 1, each.track);
    const auto edge = [&](const char* key, double place) {
      Json& handle = editable.add_handle(fmt::format("{}: {} position", label, key), 0, 0,
                                         moving(place, key), nullptr, change);
      handle["row"] = i;
      handle["small"] = true;
    };
    edge("first", each.first_on_position);
    if (last) edge("last", *last);
    rows.push_back(
        {{"label", label},
         {"line", editable.line(fmt::format("switch[{}]", i + 1))},
         {"cells",
          {cell("first", each.first_on_position), cell(last ? "last" : "", change["last"])}},
         {"change", change},
         {"remove", nullptr}});
  }
  const std::string& unit = editable.spec().units.x;
  editable.add_table(
      {{"name", "switches"},
       {"title", "Cam switches"},
       {"heads", {"switch", fmt::format("on from [{}]", unit), fmt::format("to [{}]", unit)}},
       {"rows", std::move(rows)}});
}

}  // namespace

void add_cam(Editable& editable) {
  const auto* cam = std::get_if<CamSpec>(&editable.spec().subject);
  if (cam == nullptr) return;
  for (std::size_t k = 0; k <= cam->segments.size(); ++k) add_knot(editable, *cam, k);
  Json rows = Json::array();
  for (std::size_t i = 0; i < cam->segments.size(); ++i) add_points_of(editable, *cam, i, rows);
  const Units& units = editable.spec().units;
  if (!rows.empty())
    editable.add_table({{"name", "points"},
                        {"title", "Points"},
                        {"heads",
                         {"point", fmt::format("master [{}]", units.x),
                          fmt::format("slave [{}]", units.position)}},
                        {"rows", std::move(rows)}});
  add_switches(editable);
  editable.permit_insert();
  for (const char* begin : {"start.", "segment[", "switch["}) editable.hide(begin);
}

}  // namespace jounce::edit_detail
