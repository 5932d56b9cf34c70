// SPDX-License-Identifier: Apache-2.0
#include "edit/src/editable.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "edit/src/kinds/kinds.hpp"

namespace jounce::edit_detail {
namespace {

constexpr std::size_t most_rows = 500;  ///< a list with more rows is edited as text

std::string element(const std::string& list, std::size_t i) {
  return fmt::format("{}[{}]", list, i + 1);
}

std::string with_unit(const std::string& name, const std::string& unit) {
  return unit.empty() || unit == "1" ? name : fmt::format("{} [{}]", name, unit);
}

}  // namespace

Editable::Editable(const Spec& spec, const std::vector<Input>& axes)
    : spec_(spec), numbers_(numbers_of(spec.document)) {
  for (const Input& axis : axes) curves_.push_back(&*axis.curve);
  for (std::size_t i = 0; i < numbers_.size(); ++i) index_[numbers_[i].key] = i;
}

const TextNumber* Editable::find(const std::string& key) const {
  const auto at = index_.find(key);
  return at == index_.end() ? nullptr : &numbers_[at->second];
}

bool Editable::can_have(const std::string& key) const {
  return index_.contains(key) || spec_.document.known.contains(key);
}

std::size_t Editable::count(const std::string& list) const {
  std::size_t n = 0;
  while (spec_.document.places.contains(element(list, n))) ++n;
  return n;
}

int Editable::line(const std::string& key) const {
  const auto at = spec_.document.places.find(key);
  return at == spec_.document.places.end() ? 0 : at->second.line;
}

Json Editable::coordinate(const std::optional<double>& place, const std::string& key) const {
  const TextNumber* number = find(key);
  return {{"place", place ? Json(*place) : Json()},
          {"key", can_have(key) ? Json(key) : Json()},
          {"value", number != nullptr ? Json(number->value) : Json()}};
}

Json Editable::fixed(double place) {
  return {{"place", place}, {"key", nullptr}, {"value", nullptr}};
}

Json& Editable::add_handle(const std::string& label, std::size_t axis, std::size_t order, Json x,
                           Json y, Json change) {
  handles_.push_back({{"label", label},
                      {"axis", axis},
                      {"order", order},
                      {"x", std::move(x)},
                      {"y", std::move(y)},
                      {"change", std::move(change)}});
  return handles_.back();
}

Json& Editable::add_plane_handle(const std::string& label, Json at) {
  plane_.push_back({{"label", label}, {"at", std::move(at)}, {"change", numbers_change()}});
  return plane_.back();
}

void Editable::add_points(const PointList& points) {
  const std::size_t n = count(points.list);
  if (n == 0 || n > most_rows) return hide(points.list + "[");
  std::vector<std::string> columns;
  Json heads = Json::array();
  heads.push_back(points.one);
  for (std::size_t c = 0; c < points.columns.size(); ++c)
    for (std::size_t i = 0; i < n; ++i) {
      const std::string key = element(points.list, i) + "." + points.columns[c];
      if (!can_have(key)) continue;
      const TextNumber* number = find(key);
      const std::string& head = points.heads.empty() ? points.columns[c] : points.heads[c];
      heads.push_back(
          with_unit(head, number != nullptr ? number->unit : spec_.document.known.at(key)));
      columns.push_back(points.columns[c]);
      break;
    }
  Json rows = Json::array();
  for (std::size_t i = 0; i < n; ++i) {
    const std::string row = element(points.list, i);
    Json cells = Json::array();
    for (const std::string& column : columns) {
      const std::string key = row + "." + column;
      const TextNumber* number = find(key);
      cells.push_back({{"key", can_have(key) ? Json(key) : Json()},
                       {"value", number != nullptr ? Json(number->value) : Json()}});
      shown_.insert(key);
    }
    rows.push_back({{"label", std::to_string(i + 1)},
                    {"line", line(row)},
                    {"cells", std::move(cells)},
                    {"change", numbers_change()},
                    {"remove", n > 1 ? Json{{"do", "remove"}, {"row", row}} : Json()}});
  }
  add_table({{"name", points.list}, {"title", points.title}, {"heads", heads}, {"rows", rows}});
}

void Editable::add_other_numbers() {
  Json rows = Json::array();
  for (const TextNumber& number : numbers_) {
    const auto is_hidden = [&](const std::string& begin) { return number.key.starts_with(begin); };
    if (shown_.contains(number.key) || std::any_of(hidden_.begin(), hidden_.end(), is_hidden))
      continue;
    rows.push_back({{"label", with_unit(number.key, number.unit)},
                    {"line", number.line},
                    {"cells", Json::array({Json{{"key", number.key}, {"value", number.value}}})},
                    {"change", numbers_change()},
                    {"remove", nullptr}});
  }
  if (rows.empty() || rows.size() > most_rows) return;
  add_table({{"name", "numbers"},
             {"title", tables_.empty() ? "Numbers" : "Other numbers"},
             {"heads", {"number", "value"}},
             {"rows", std::move(rows)}});
}

std::string Editable::json() {
  add_other_numbers();
  return Json{{"handles", std::move(handles_)},
              {"plane", std::move(plane_)},
              {"tables", std::move(tables_)},
              {"insert", insert_},
              {"plane_insert", plane_insert_}}
      .dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::string editable_json(const Spec& spec, const std::vector<Input>& axes) {
  Editable editable(spec, axes);
  add_cam(editable);
  add_knots(editable);
  add_time_table(editable);
  add_follow(editable);
  add_moves(editable);
  add_path(editable);
  return editable.json();
}

}  // namespace jounce::edit_detail
