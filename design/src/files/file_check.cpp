// SPDX-License-Identifier: Apache-2.0
#include "jounce/design/files/file_check.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "jounce/base/nearest.hpp"
#include "jounce/base/units.hpp"
#include "jounce/design/cam_check.hpp"
#include "jounce/profiles/error.hpp"

#include "design/src/check_text.hpp"

namespace jounce {
namespace {

void set_limit(Limits& limits, const std::string& text, const Labels& labels) {
  const auto equals = text.find('=');
  const std::string key = text.substr(0, equals);
  const auto& names = labels.over_master ? OverMaster::names : OverTime::names;
  const std::vector<std::pair<std::string, std::optional<double>*>> all{
      {"position_min", &limits.position_min},
      {"position_max", &limits.position_max},
      {names[1], &limits.velocity},
      {names[2], &limits.acceleration},
      {names[3], &limits.jerk}};
  for (const auto& [name, target] : all) {
    if (equals == std::string::npos || key != name) continue;
    const std::string quantity_name = name.starts_with("position") ? "position" : name;
    try {
      *target = quantity(text.substr(equals + 1), labels.unit_of(quantity_name));
    } catch (const InputError& error) {
      throw InputError("limit " + key, error.value(), error.rule());
    }
    return;
  }
  std::vector<std::string> known;
  for (const auto& [name, target] : all) known.push_back(name);
  if (equals == std::string::npos)
    throw InputError(
        "limit", text,
        fmt::format("must be KEY=VALUE with one of the keys {}", fmt::join(known, ", ")));
  const std::string near = nearest(key, known);
  const bool over_time =
      labels.over_master &&
      std::find(OverTime::names.begin(), OverTime::names.end(), key) != OverTime::names.end();
  throw InputError(
      "limit", text,
      fmt::format("{} is not a limit here: use one of {}{}{}", key, fmt::join(known, ", "),
                  near.empty() ? "" : ": did you mean " + near + "?",
                  over_time ? "; [limits.slave] of the spec has the limits over time" : ""));
}

}  // namespace

void set_limits(Limits& limits, const std::vector<std::string>& texts, const Labels& labels) {
  for (const std::string& text : texts) set_limit(limits, text, labels);
  try {
    require_valid(limits);
  } catch (const InputError& error) {
    const std::string prefix = labels.over_master ? "limit geo_" : "limit ";
    const bool position = error.key().starts_with("position");
    throw InputError((position ? "limit " : prefix) + error.key(), error.value(), error.rule());
  }
}

EngageState engage_state(const Input& input, const EngageTexts& texts) {
  const Units& units = input.labels.units;
  EngageState at;
  const auto read = [&](const char* key, const std::string& text, const std::string& unit,
                        std::optional<double>& value) {
    if (text.empty()) return;
    if (!input.spec || !input.spec->coupling)
      throw InputError(key, text, "needs a spec with [coupling]");
    try {
      value = quantity(text, unit);
    } catch (const InputError& error) {
      throw InputError(key, error.value(), error.rule());
    }
  };
  read("slave", texts.slave, units.position, at.slave);
  read("master", texts.master, units.x, at.master);
  read("master_velocity", texts.master_velocity, rate_unit(units.x, "s", 1), at.master_velocity);
  return at;
}

Report axis_report(const Input& input, int continuity, const EngageState& at) {
  Report report = checked(input, continuity, at);
  add_not_limited(report, input);
  if (!input.plan)
    add_no_limits(report, input.spec ? &*input.spec
                                     : nullptr);  // the plan of a path keeps the limits of the path
  return report;
}

bool FileCheck::ok(bool strict) const {
  if (path && !path->along.ok()) return false;
  return std::all_of(reports.begin(), reports.end(), [&](const Report& report) {
    return report.ok() && (!strict || report.warnings() == 0);
  });
}

FileCheck file_check(const std::vector<Input>& axes, std::vector<Report> reports) {
  FileCheck check{std::move(reports)};
  if (const Input& first = axes.front(); first.plan)
    check.path = summary_of(*first.spec, *first.plan);
  return check;
}

std::string file_check_text(const FileCheck& check, const std::vector<Input>& axes) {
  const Input& first = axes.front();
  std::string text;
  if (check.path) text += path_text(*first.spec, *check.path) + "\n";
  if (first.overlap) text += overlap_text(*first.spec, *first.overlap) + "\n";
  for (std::size_t i = 0; i < axes.size(); ++i)
    text += (i == 0 ? "" : "\n") + check_text(check.reports[i], axes[i]);
  return text;
}

std::string file_check_json(const FileCheck& check, const std::vector<Input>& axes) {
  std::vector<std::pair<std::string, std::string>> documents;
  for (std::size_t i = 0; i < axes.size(); ++i)
    documents.emplace_back(axes[i].axis, check_json(check.reports[i], axes[i]));
  const Input& first = axes.front();
  auto document = nlohmann::ordered_json::parse(axes_json(documents));
  const auto add = [&](const char* key, const std::string& text) {
    document[key] = nlohmann::ordered_json::parse(text);
  };
  if (check.path) add("path", path_json(*first.spec, *check.path));
  if (first.overlap) add("overlap", overlap_json(*first.spec, *first.overlap));
  return document.dump();
}

}  // namespace jounce
