// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <functional>
#include <string_view>

#include <fmt/format.h>

#include "jounce/design/files/file_difference.hpp"

namespace jounce {
namespace {

/// The sections and keys that describe a curve. A key that is missing here is reported although the
/// comparison of the curves covers it.
constexpr std::array<std::string_view, 28> curve_sections{
    "start",   "segment", "periodic", "slave_period", "boundaries", "then",     "from",
    "drawing", "points",  "polydyne", "gear",         "follow",     "knife",    "shear",
    "indexer", "move",    "dynamics", "command",      "sync",       "duration", "times",
    "norm",    "point",   "path",     "gcode",        "knot",       "pt",       "optimize"};

/// The first part of a key: "segment" of "segment[2].law".
std::string_view section_of_key(std::string_view key) {
  return key.substr(0, key.find_first_of(".["));
}

/// True for a key of [limits] of an axis that Limits contains: "limits.velocity", "axis[2].limits.jerk".
bool is_axis_limit(std::string_view key) {
  constexpr std::string_view table = "limits.";
  if (key.starts_with("axis[")) key.remove_prefix(std::min(key.find('.') + 1, key.size()));
  if (!key.starts_with(table)) return false;
  key.remove_prefix(table.size());
  return key.find('.') == key.npos;
}

bool is_unit_key(std::string_view key) {
  return key.starts_with("units.") ||
         (key.starts_with("axis[") && key.find("].units.") != key.npos);
}

/// True if the comparison of the curves found a difference, also of its interval.
bool has_other_curve(const Comparison& c) {
  return !std::all_of(c.changes.begin(), c.changes.end(), std::mem_fn(&Change::none)) ||
         std::any_of(c.remarks.begin(), c.remarks.end(), [](const Remark& remark) {
           return remark.what == "start" || remark.what == "end" || remark.what == "outside";
         });
}

bool has_other_table(const Comparison& c) {
  return std::any_of(c.remarks.begin(), c.remarks.end(),
                     [](const Remark& remark) { return remark.what == "[table]"; });
}

}  // namespace

std::vector<KeyChange> take_key_changes(const Spec& before, const Spec& after,
                                        std::vector<Comparison>& comparisons) {
  const bool curves = std::any_of(comparisons.begin(), comparisons.end(), has_other_curve);
  const bool tables = std::any_of(comparisons.begin(), comparisons.end(), has_other_table);
  std::vector<KeyChange> others;
  for (KeyChange& change : changed_keys(before, after)) {
    const std::string_view section = section_of_key(change.key);
    const bool of_curve =
        std::find(curve_sections.begin(), curve_sections.end(), section) != curve_sections.end();
    if (is_axis_limit(change.key) || is_unit_key(change.key) || (tables && section == "table"))
      continue;
    if (change.limit && !comparisons.empty()) {
      const bool of_axis = section == "limits";
      const std::string name = of_axis ? change.key.substr(section.size() + 1) : change.key;
      comparisons.front().remarks.push_back({"limit " + name, change.before, change.after});
    } else if (!curves || !of_curve) {
      others.push_back(std::move(change));
    }
  }
  return others;
}

std::string to_text(const std::vector<KeyChange>& keys) {
  constexpr std::size_t most = 8;
  std::string text;
  for (std::size_t i = 0; i < std::min(most, keys.size()); ++i) {
    const auto& [key, before, after, limit, place] = keys[i];
    text += fmt::format("{}{} {} -> {}", i == 0 ? "differs outside the curve: " : "; ", key,
                        before.empty() ? "none" : before, after.empty() ? "none" : after);
  }
  return keys.size() > most ? text + fmt::format("; and {} more", keys.size() - most) : text;
}

std::string headline_of(const std::vector<KeyChange>& keys) {
  if (keys.empty()) return "";
  return keys.size() == 1 ? keys.front().key + " differs"
                          : fmt::format("{} keys outside the curve differ", keys.size());
}

}  // namespace jounce
