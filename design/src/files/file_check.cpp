// SPDX-License-Identifier: Apache-2.0
#include "jounce/design/detail/file_check.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "jounce/base/detail/nearest.hpp"
#include "jounce/base/units.hpp"
#include "jounce/design/detail/axes.hpp"
#include "jounce/design/detail/cam_check.hpp"
#include "jounce/profiles/error.hpp"

#include "design/src/check/check_text.hpp"
#include "design/src/input/against_spec.hpp"

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
  if (labels.over_master)  // check_reports() reads these
    known.insert(known.end(), OverTime::names.begin() + 1, OverTime::names.end());
  if (equals == std::string::npos)
    throw InputError(
        "limit", text,
        fmt::format("must be KEY=VALUE with one of the keys {}", fmt::join(known, ", ")));
  const std::string near = nearest(key, known);
  throw InputError("limit", text,
                   near.empty() ? fmt::format("{} is not a limit here: use one of {}", key,
                                              fmt::join(known, ", "))
                                : key + " is not a limit here: did you mean " + near + "?");
}

/// The order of the derivative over time that a text limits, 1 to 3; 0 for any other text.
std::size_t order_over_time(const std::string& text) {
  const auto equals = text.find('=');
  const auto name = std::find(OverTime::names.begin() + 1, OverTime::names.end(),
                              equals == std::string::npos ? "" : text.substr(0, equals));
  return name == OverTime::names.end() ? 0
                                       : static_cast<std::size_t>(name - OverTime::names.begin());
}

/// A quantity of an option, and the unit that its text gives.
double given_quantity(const std::string& key, const std::string& text, const std::string& value,
                      const std::string& unit) {
  try {
    const double number = quantity(value, unit);
    if (!(number > 0)) throw InputError("", value, "must be greater than 0");
    return number;
  } catch (const InputError& error) {
    throw InputError(key, text, error.rule());
  }
}

/// The spec of a table alone: its units, and no motion of its own.
Spec spec_of_table(const Input& input) {
  const Units& units = input.labels.units;
  if (units.x.empty() || units.position.empty())
    throw InputError("limit", "",
                     "over time needs units, and " + input.name +
                         " has none: give its spec with --against, or convert it with "
                         "--master-unit and --position-unit");
  Spec spec;
  spec.name = input.name;
  spec.units = units;
  spec.time_unit = "s";
  spec.subject = NamedCam{std::get<Cam>(*input.curve), {}};
  return spec;
}

/// The velocity of the master of a cam, per unit of time: "900 deg/s", or cycles as "150 cpm".
double master_velocity_of(const Input& input, const std::string& text) {
  const std::string unit = rate_unit(input.labels.units.x, input.spec->time_unit, 1);
  const std::string cycles = rate_unit("", input.spec->time_unit, 1);
  const std::string given(quantity_unit(text));
  const Cam& cam = std::get<Cam>(*input.curve);
  if (repeats(cam.outside()) && is_unit(given) && !is_convertible(given, unit) &&
      is_convertible(given, cycles))
    return given_quantity("master_velocity", text, text, cycles) * cam.length();
  return given_quantity("master_velocity", text, text, unit);
}

/// Sets the limits of a cam over time, and the speed of its master.
void set_slave_limits(Input& input, const std::vector<std::string>& texts,
                      const std::string& master_velocity) {
  if (!input.spec) input.spec = spec_of_table(input);
  Spec& spec = *input.spec;
  const std::array limits{&spec.slave.velocity, &spec.slave.acceleration, &spec.slave.jerk};
  for (const std::string& text : texts) {
    const std::size_t k = order_over_time(text);
    const std::string value = text.substr(text.find('=') + 1);
    const std::string unit = rate_unit(spec.units.position, spec.time_unit, static_cast<int>(k));
    *limits[k - 1] = given_quantity("limit " + std::string(OverTime::names[k]), value, value, unit);
    if (const std::string given(quantity_unit(value)); !given.empty())
      spec.document.given["limits.slave." + std::string(OverTime::names[k])] = given;
  }
  if (!master_velocity.empty()) {
    const double length = std::get<Cam>(*input.curve).length();
    if (!spec.master) spec.master = MasterSpec{0, length, {}};
    spec.master->velocity = master_velocity_of(input, master_velocity);
    spec.document.given["master.velocity"] = std::string(quantity_unit(master_velocity));
    if (spec.document.given["master.velocity"].empty())
      spec.document.given.erase("master.velocity");
  }
  if (!spec.master)
    throw InputError("limit", texts.front(),
                     "is over time, and the speed of the master is not given: add "
                     "--master-velocity, such as \"900 " +
                         rate_unit(spec.units.x, spec.time_unit, 1) + "\"");
}

bool limits_slave(const Input& input) {
  return input.spec &&
         (input.spec->slave.velocity || input.spec->slave.acceleration || input.spec->slave.jerk);
}

}  // namespace

void set_limits(Limits& limits, const std::vector<std::string>& texts, const Labels& labels) {
  for (const std::string& text : texts) set_limit(limits, text, labels);
  try {
    require_valid(limits);
  } catch (const InputError& error) {
    const std::string prefix = labels.over_master ? "limit geo_" : "limit ";
    const bool position = error.key().starts_with("position");
    const std::string unit = position ? labels.unit_of("position") : "";
    const auto with_its_unit = [&](const std::string& number) {
      return unit.empty() || number.empty() ? number : number + " " + unit;
    };
    throw InputError((position ? "limit " : prefix) + error.key(), with_its_unit(error.value()),
                     with_its_unit(error.rule()));
  }
}

EngageState engage_state(const Input& input, const EngageTexts& texts) {
  const Units& units = input.labels.units;
  EngageState at;
  const auto read = [&](const char* key, const std::string& text, const std::string& unit,
                        std::optional<double>& value) {
    if (text.empty()) return;
    if (!input.spec || !input.spec->coupling)
      throw InputError(
          key, text,
          std::string(key) != "master_velocity"
              ? "applies to a spec with [coupling]: add [coupling], or leave out this option"
          : input.labels.over_master
              ? "applies to a spec with [coupling], or to a limit over time: add --limit "
                "velocity, acceleration or jerk, or leave out this option"
              : "applies to a cam, and this motion is over time: leave it out");
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

std::vector<Report> check_reports(std::vector<Input>& axes, const CheckOptions& options) {
  if (!options.against.empty() && !options.axis.empty()) {
    if (axes.size() == 1 && axes.front().axis.empty()) axes.front().axis = options.axis;
    const std::string file = axes.front().file;
    axes = axes_named(std::move(axes), options.axis, file);
  }
  if (!options.against.empty() &&
      (!options.selects_tables || may_be_made_from(axes.front(), options.against)))
    set_against(axes, options.against, options.tolerances);
  if (options.against.empty() && options.limits.empty())
    for (Input& input : axes) set_limits_of_header(input);
  std::vector<Report> reports;
  for (Input& input : axes) {
    std::vector<std::string> own, over_time;
    for (const std::string& text : options.limits) {
      if (std::count(text.begin(), text.end(), '=') > 1)
        throw InputError("limit", text, "contains two limits: give each with its own --limit");
      (input.labels.over_master && order_over_time(text) > 0 ? over_time : own).push_back(text);
    }
    set_limits(input.limits, own, input.labels);
    EngageTexts start = options.start;
    const bool has_coupling = input.spec && input.spec->coupling;
    const bool sets_speed = !start.master_velocity.empty() && input.labels.over_master &&
                            (!over_time.empty() || (limits_slave(input) && !has_coupling));
    if (!over_time.empty() || sets_speed)
      set_slave_limits(input, over_time, sets_speed ? start.master_velocity : "");
    if (sets_speed && !has_coupling) start.master_velocity.clear();
    reports.push_back(axis_report(input, options.continuity, engage_state(input, start)));
  }
  return reports;
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
