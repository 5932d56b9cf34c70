// SPDX-License-Identifier: Apache-2.0
#include "spec/src/toml/point_file.hpp"

#include <algorithm>
#include <charconv>
#include <filesystem>

#include "jounce/base/detail/listed.hpp"

namespace jounce::spec_detail {
namespace {

/// The error of a column that the table does not have. A wanted column whose unit is not known has
/// its unit in its name: "position (furlong)".
InputError other_column(const Points& points, const PointColumn& column,
                        const std::vector<std::string>& wanted) {
  for (const auto& [mark, end] : {std::pair<std::string, std::string>{"(", ")"}, {" / ", ""}}) {
    const auto at = column.name.find(mark);
    if (at == std::string::npos || at == 0 || !column.name.ends_with(end)) continue;
    std::string name = column.name.substr(0, column.name.find_last_not_of(' ', at - 1) + 1);
    Points other{.columns = {{.name = name}}};
    other.name_columns(wanted);
    name = other.columns.front().name;
    if (std::find(wanted.begin(), wanted.end(), name) == wanted.end() ||
        points.find(name) != nullptr)
      continue;
    const auto from = at + mark.size();
    return {name, column.name.substr(from, column.name.size() - from - end.size()),
            "is not a known unit: write one such as mm, deg, s or mm/s"};
  }
  return {column.name, "",
          "is not a column of this table; possible columns: " + listed(wanted) +
              ": delete the column, or give it one of these names"};
}

}  // namespace

std::optional<Points> read_point_file(TomlReader& owner, const char* rows,
                                      const std::vector<std::string>& columns) {
  const auto given = owner.optional_text("points");
  if (!given) return std::nullopt;
  if (owner.has(rows))
    owner.fail("points", '"' + *given + '"',
               std::string("cannot be combined with [[") + rows + "]]: give one of the two");
  const std::filesystem::path spec = owner.document().name;
  const std::string file = (spec.parent_path() / *given).string();
  Points points = owner.file_of("points", file, [&] { return jounce::read_points(file); });
  points.name_columns(columns);
  for (const PointColumn& column : points.columns)
    if (std::find(columns.begin(), columns.end(), column.name) == columns.end())
      throw other_column(points, column, columns)
          .at(points.document, static_cast<int>(points.header));
  return points;
}

void require_ascending(const Points& points, const PointQuantity& x) {
  const PointColumn* const column = points.find(x.name);
  if (column == nullptr) return;
  const std::string& unit = column->unit.empty() ? x.unit : column->unit;
  for (std::size_t i = 1; i < column->values.size(); ++i) {
    const double before = column->values[i - 1];
    const double now = column->values[i];
    if (!(now > before))
      throw points.error(i, x.name, now, unit,
                         "must be greater than " + number(before) + (unit.empty() ? "" : " ") +
                             unit + ", the previous point: " +
                             (now == before ? "delete one of the two points"
                                            : std::string("sort the points by ") + x.name));
  }
}

std::vector<std::size_t> types_of(const Points& points, std::span<const std::string> words) {
  std::vector<std::size_t> types(points.size(), 0);
  const PointColumn* column = points.find("type");
  if (column == nullptr) return types;
  for (std::size_t i = 0; i < types.size(); ++i) {
    const std::string& word = column->words[i];
    const auto at = std::find(words.begin(), words.end(), word);
    types[i] = static_cast<std::size_t>(at - words.begin());
    if (at != words.end()) continue;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), types[i]);
    if (error != std::errc() || end != word.data() + word.size() || types[i] >= words.size())
      throw points.error(i, "type", word,
                         "must be one of " + listed(words) + ", or its number, counted from 0");
  }
  return types;
}

std::vector<PtPoint> pt_points(const Points& points, const PointQuantity& x,
                               const PointQuantity& position, bool increments,
                               std::span<const std::string> types) {
  const std::vector<double> at = points.in_unit(x.name, x.unit);
  if (!increments) require_ascending(points, x);
  const std::vector<double> to = points.in_unit(position.name, position.unit);
  const std::vector<std::size_t> type = types_of(points, types);
  std::vector<PtPoint> all;
  all.reserve(points.size());
  PtPoint before;
  for (std::size_t i = 0; i < points.size(); ++i) {
    PtPoint point{at[i], to[i], static_cast<PtType>(type[i])};
    if (increments) point = {before.x + point.x, before.position + point.position, point.type};
    if (!(point.x > before.x))
      throw points.error(i, x.name, at[i], x.unit,
                         "must be greater than " +
                             (increments || before.x == 0
                                  ? "0"
                                  : number(before.x) + " " + x.unit + ", the previous point"));
    all.push_back(point);
    before = point;
  }
  return all;
}

InputError placed(const InputError& error, const Points& points, const ColumnUnits& units) {
  const std::string& key = error.key();
  const auto open = key.find('[');
  std::size_t point = 0;
  if (!error.document().empty() || open == key.npos ||
      std::from_chars(key.data() + open + 1, key.data() + key.size(), point).ec != std::errc() ||
      point < 1 || point > points.size())
    return error;
  const auto dot = key.find('.', open);
  const std::string column = dot == key.npos ? key : key.substr(dot + 1);
  const Document in_units{.name = {}, .text = {}, .places = {}, .units = units};
  const InputError own = in_units.located(InputError(column, error.value(), error.rule()));
  return points.error(point - 1, column, own.value(), own.rule());
}

}  // namespace jounce::spec_detail
