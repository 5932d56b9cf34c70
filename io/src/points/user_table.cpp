// SPDX-License-Identifier: Apache-2.0
#include "jounce/io/user_table.hpp"

#include <array>
#include <cmath>
#include <utility>

#include "jounce/base/units.hpp"
#include "jounce/io/points.hpp"
#include "jounce/profiles/error.hpp"

namespace jounce {
namespace {

const std::string index_rule =
    "must be a whole number from 0 to " + std::to_string(UserTable::size - 1);

bool is_index(double number) {
  return number == std::floor(number) && number >= 0 &&
         number < static_cast<double>(UserTable::size);
}

}  // namespace

void UserTable::set(std::int64_t start, const std::vector<double>& values) {
  const auto count = static_cast<std::int64_t>(values.size());
  if (start < 0 || start > size - count)
    throw InputError("start", std::to_string(start),
                     "must be such that all indices are from 0 to " + std::to_string(size - 1));
  for (const double value : values) require_finite("value", value);
  for (std::int64_t i = 0; i < count; ++i)
    entries_[start + i] = values[static_cast<std::size_t>(i)];
}

std::vector<double> UserTable::get(std::int64_t start, std::size_t count,
                                   const std::string& unit) const {
  const double factor = unit_.empty() || unit.empty() ? 1 : conversion(unit_, unit);
  std::vector<double> values;
  for (std::size_t i = 0; i < count; ++i) {
    const std::int64_t index = start + static_cast<std::int64_t>(i);
    const auto entry = entries_.find(index);
    if (entry == entries_.end())
      throw InputError("start", std::to_string(start),
                       "needs " + std::to_string(count) + " entries of the table, but the index " +
                           std::to_string(index) + " has no value");
    values.push_back(factor * entry->second);
  }
  return values;
}

std::string UserTable::text() const {
  std::string text = "index,value" + (unit_.empty() ? "" : " [" + unit_ + "]") + "\n";
  for (const auto& [index, value] : entries_)
    text += std::to_string(index) + ',' + number(value) + '\n';
  return text;
}

UserTable read_user_table(const std::string& path) {
  Points points = read_points(path);
  const std::array<std::string, 2> columns{"index", "value"};
  points.name_columns(columns);
  const std::vector<double> indices = points.in_unit("index", "");
  const PointColumn* const value = points.find("value");
  if (value == nullptr) throw InputError("value", "", "is not a column of this file").at(path, 1);
  UserTable table(value->unit);
  std::map<std::int64_t, bool> seen;
  for (std::size_t i = 0; i < indices.size(); ++i) {
    const auto refuse = [&](const std::string& rule) {
      throw points.error(i, "index", indices[i], "", rule);
    };
    if (!is_index(indices[i])) refuse(index_rule);
    const auto index = static_cast<std::int64_t>(indices[i]);
    if (std::exchange(seen[index], true)) refuse("occurs twice");
    table.set(index, {value->values[i]});
  }
  return table;
}

}  // namespace jounce
