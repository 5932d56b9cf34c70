// SPDX-License-Identifier: Apache-2.0
#include "edit/src/cam_json.hpp"

#include <optional>
#include <utility>

#include <nlohmann/json.hpp>

#include "jounce/base/units.hpp"
#include "jounce/cam/design/design.hpp"

#include "edit/src/cam_geometry.hpp"
#include "edit/src/json_reader.hpp"

namespace jounce::edit_detail {
namespace {

Json optional(const std::optional<double>& value) {
  return value ? Json(*value) : Json();
}

int line_of(const Spec& spec, const std::string& key) {
  const auto at = spec.document.places.find(key);
  return at == spec.document.places.end() ? 0 : at->second.line;
}

Json knot_json(const CamSpec& cam, std::size_t i) {
  const CamKnot& knot = knot_of(cam, i);
  const Settable settable = settable_at(cam, i);
  return {{"master", knot.master},
          {"slave", knot.slave},
          {"geo_velocity", optional(knot.geo_velocity)},
          {"geo_acceleration", optional(knot.geo_acceleration)},
          {"sets_velocity", settable.velocity},
          {"sets_acceleration", settable.acceleration}};
}

/// The points of a segment; null if they are in another file, or too many for handles.
Json points_json(const Spec& spec, const CamSegment& segment, std::size_t i) {
  constexpr std::size_t most_points = 500;
  const std::string first = "segment[" + std::to_string(i + 1) + "].points[1]";
  if (segment.points.size() > most_points || !spec.document.places.contains(first)) return nullptr;
  Json all = Json::array();
  for (const CamPoint& point : segment.points) all.push_back({point.master, optional(point.slave)});
  return all;
}

/// The switches that use the position of the master.
Json switches_json(const Spec& spec) {
  Json all = Json::array();
  if (spec.switches.of != SwitchesOf::master) return all;
  for (const CamSwitch& each : spec.switches.table.switches)
    all.push_back({{"track", each.track},
                   {"first", each.first_on_position},
                   {"last", optional(each.last_on_position)},
                   {"duration", optional(each.duration)}});
  return all;
}

Json segment_json(const Spec& spec, const CamSegment& segment, std::size_t i) {
  Json json{{"name", segment.name},
            {"law", name(segment.law)},
            {"inflection", optional(segment.form.inflection)},
            {"straight", optional(segment.form.straight)},
            {"shares", Json()},
            {"points", segment.points.size()},
            {"through", points_json(spec, segment, i)},
            {"line", line_of(spec, "segment[" + std::to_string(i + 1) + "]")}};
  if (segment.form.shares) json["shares"] = *segment.form.shares;
  return json;
}

}  // namespace

std::string cam_json(const Spec& spec) {
  const auto* cam = std::get_if<CamSpec>(&spec.subject);
  if (cam == nullptr) return "null";
  Json knots = Json::array();
  for (std::size_t i = 0; i <= cam->segments.size(); ++i) knots.push_back(knot_json(*cam, i));
  Json segments = Json::array();
  for (std::size_t i = 0; i < cam->segments.size(); ++i)
    segments.push_back(segment_json(spec, cam->segments[i], i));
  const Units& units = spec.units;
  return Json{{"periodic", cam->periodic},
              {"units",
               {{"master", units.x},
                {"slave", units.position},
                {"geo_velocity", rate_unit(units.position, units.x, 1)},
                {"geo_acceleration", rate_unit(units.position, units.x, 2)}}},
              {"knots", std::move(knots)},
              {"segments", std::move(segments)},
              {"switches", switches_json(spec)}}
      .dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace jounce::edit_detail
