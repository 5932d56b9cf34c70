// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include "jounce/io/user_table.hpp"

#include "spec/src/toml/parts.hpp"

namespace jounce::spec_detail {
namespace {

const std::array<std::string, 2> grid_rules{"linear", "cubic"};
constexpr std::size_t most_points = 1'000'000;  ///< greatest number of points of a grid

/// The number of points along one reference.
std::size_t reference_count(TomlReader& reference) {
  if (!reference.has("count")) reference.fail("count", "", "is missing: add count = WHOLE NUMBER");
  const std::size_t count = reference.optional_count("count").value_or(0);
  if (count < 2 || count > most_points)
    reference.fail("count", std::to_string(count), "must be from 2 to 1e6");
  return count;
}

/// Reads `count` entries of a user table (HMPL manual, chapter 11) from user_table = { file, start }.
std::vector<double> user_values(TomlReader& owner, std::size_t count, const std::string& unit) {
  if (owner.has("values"))
    owner.fail("user_table", "", "cannot be combined with values: give one of the two");
  TomlReader table = owner.table("user_table");
  const std::filesystem::path given(table.text("file", "FILE.csv"));
  const std::int64_t start = table.optional_whole("start").value_or(0);
  table.finish();
  const auto file = (std::filesystem::path(owner.document().name).parent_path() / given).string();
  try {
    return table.file_of("file", file, [&] { return read_user_table(file); })
        .get(start, count, unit);
  } catch (const InputError& error) {
    if (error.key() != "start") throw;
    table.fail("start", error.value(), error.rule());
  }
}

}  // namespace

CompensationSpec read_correction_grid(
    TomlReader& table, const std::string& unit,
    const std::function<std::string(TomlReader& reference)>& unit_of_reference) {
  CompensationSpec grid;
  if (const auto rule = table.optional_choice("rule", grid_rules))
    grid.rule = static_cast<GridRule>(*rule);
  grid.most = table.optional_number("most", unit).value_or(grid.most);
  if (!(grid.most > 0)) table.fail("most", number(grid.most), "must be greater than 0");
  std::size_t points = 1;
  for (TomlReader& reference : table.tables("reference")) {
    const std::string of_grid = unit_of_reference(reference);
    grid.axes.push_back({reference.number("base", of_grid), reference.number("interval", of_grid),
                         reference_count(reference)});
    points *= grid.axes.back().count;
    if (points > most_points)
      table.fail("reference", "", "makes a grid of more than 1e6 points: lower the counts");
    reference.finish();
  }
  if (grid.axes.empty())
    table.fail("reference", "",
               "is missing: add [[" + table.path("reference") +
                   "]] with base, interval and count for each axis that the correction depends "
                   "on, one to three");
  if (!table.has("user_table") && !table.has("values"))
    table.fail("values", "",
               "is missing: add values = [NUMBER, ...], one for each of the " +
                   std::to_string(points) + " points of the grid, or user_table");
  grid.values = table.has("user_table")
                    ? user_values(table, points, unit)
                    : table.numbers("values", std::vector<std::string>(points, unit));
  return grid;
}

std::optional<AxisSpec::Compensation> read_axis_compensation(TomlReader& top, const Units& units,
                                                             const std::string& name) {
  auto table = top.optional_table("compensation");
  if (!table) return std::nullopt;
  AxisSpec::Compensation spec;
  const auto unit_of = [&](TomlReader& reference) {
    const std::string axis = reference.optional_text("axis").value_or("");
    const std::string unit = reference.optional_text("unit").value_or(units.position);
    const bool own = axis.empty() || axis == name;
    if (own && unit != units.position)
      reference.fail("unit", '"' + unit + '"',
                     "must be " + units.position + ", the unit of this axis: leave it out");
    const std::string listed = own ? "" : axis;
    if (std::find(spec.axes.begin(), spec.axes.end(), listed) != spec.axes.end())
      reference.fail("axis", '"' + axis + '"',
                     listed.empty() ? "is this axis, as in another reference: leave one of them out"
                                    : "is the axis of two references: leave one of them out");
    spec.axes.push_back(listed);
    spec.units.push_back(unit);
    return unit;
  };
  if (!table->has("most"))
    table->fail("most", "",
                "is missing: give the greatest correction that is permitted; HIMC permits 1 mm");
  spec.table = read_correction_grid(*table, units.position, unit_of);
  table->finish();
  for (std::size_t i = 0; i < spec.table.values.size(); ++i)
    if (const double value = spec.table.values[i]; std::abs(value) > spec.table.most)
      table->fail(("values[" + std::to_string(i + 1) + "]").c_str(), number(value),
                  "exceeds most, " + number(spec.table.most) + ' ' + units.position +
                      " (HIMC error 0x83aa0802)");
  try {
    (void)Compensation(spec.table);
  } catch (const InputError& error) {
    std::string key = error.key();
    if (key.starts_with("axes[")) key.replace(0, 4, "reference");
    table->fail(key.c_str(), error.value(), error.rule());
  }
  return spec;
}

}  // namespace jounce::spec_detail
