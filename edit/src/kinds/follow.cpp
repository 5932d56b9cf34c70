// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cstdint>
#include <string>
#include <utility>
#include <variant>

#include <fmt/format.h>

#include "jounce/spec/spec.hpp"

#include "edit/src/kinds/kinds.hpp"

namespace jounce::edit_detail {
namespace {

/// The ends of the segments of a table, in its first pass. A pass counts from its origin.
void add_table_handles(Editable& editable, const FollowTable& table, const std::string& list,
                       const PtPoint& origin) {
  for (std::size_t i = 0; i < table.segments.size(); ++i) {
    const PtPoint& end = table.segments[i];
    const std::string row = fmt::format("{}[{}]", list, i + 1);
    Json& handle =
        editable.add_handle(fmt::format("end of {} {}", list, i + 1), 0, 0,
                            editable.coordinate(origin.x + end.x, row + ".master"),
                            editable.coordinate(origin.position + end.position, row + ".slave"));
    const bool last = i + 1 == table.segments.size();
    handle["between"] = {origin.x + (i == 0 ? 0 : table.segments[i - 1].x),
                         last ? Json() : Json(origin.x + table.segments[i + 1].x)};
    if (table.segments.size() > 1) handle["remove"] = {{"do", "remove"}, {"row", row}};
  }
}

void add_tables(Editable& editable, const FollowSpec& spec) {
  const bool one = editable.count("segment") > 0;
  PtPoint origin;
  for (std::size_t k = 0; k < spec.tables.size(); ++k) {
    const FollowTable& table = spec.tables[k];
    const std::string list = one ? "segment" : fmt::format("follow.table[{}].segment", k + 1);
    const std::string title = one ? "Segments" : fmt::format("Segments of table {}", k + 1);
    editable.add_points({list, title, "segment", {"master", "slave"}});
    // The rows are not the segments if a row has `repeat`, or if they are in another file.
    if (editable.count(list) == table.segments.size())
      add_table_handles(editable, table, list, origin);
    const auto loops = static_cast<double>(std::max<std::int64_t>(table.loops, 1));
    if (table.segments.empty()) return;
    origin.x += loops * table.segments.back().x;
    origin.position += loops * table.segments.back().position;
  }
}

void add_plan(Editable& editable, const FollowPlan& plan) {
  editable.add_points({"point", "Sync points", "point", {"master", "slave", "ratio"}});
  editable.add_points({"zone", "Sync zones", "zone", {"from", "to", "ratio", "slave"}});
  for (std::size_t i = 0; i < plan.points.size(); ++i) {
    const std::string row = fmt::format("point[{}]", i + 1);
    const std::string label = fmt::format("sync point {}", i + 1);
    Json& handle = editable.add_handle(label, 0, 0,
                                       editable.coordinate(plan.points[i].master, row + ".master"),
                                       editable.coordinate(plan.points[i].slave, row + ".slave"));
    if (plan.points.size() > 1) handle["remove"] = {{"do", "remove"}, {"row", row}};
    editable.add_handle(label, 0, 1, Editable::fixed(plan.points[i].master),
                        editable.coordinate(std::nullopt, row + ".ratio"));
  }
  for (std::size_t i = 0; i < plan.zones.size(); ++i) {
    const FollowZone& zone = plan.zones[i];
    const std::string row = fmt::format("zone[{}]", i + 1);
    const std::string label = fmt::format("zone {}", i + 1);
    const Json on_curve{{"place", nullptr}, {"key", nullptr}, {"value", nullptr}};
    for (const auto& [key, place] : {std::pair{"from", zone.from}, {"to", zone.to}}) {
      Json& handle = editable.add_handle(fmt::format("{}: {}", label, key), 0, 1,
                                         editable.coordinate(place, row + "." + key), on_curve);
      handle["small"] = true;
    }
    editable.add_handle(label + ": ratio", 0, 1, Editable::fixed((zone.from + zone.to) / 2),
                        editable.coordinate(std::nullopt, row + ".ratio"));
  }
  if (!plan.points.empty()) editable.permit_insert();
}

}  // namespace

void add_follow(Editable& editable) {
  const auto* sync = std::get_if<SyncSpec>(&editable.spec().subject);
  const auto* follow = sync == nullptr ? nullptr : std::get_if<FollowPart>(sync);
  if (follow == nullptr) return;
  if (const auto* tables = std::get_if<FollowSpec>(&follow->slave))
    add_tables(editable, *tables);
  else
    add_plan(editable, std::get<FollowPlan>(follow->slave));
}

}  // namespace jounce::edit_detail
