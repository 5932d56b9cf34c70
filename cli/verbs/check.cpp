// SPDX-License-Identifier: Apache-2.0
#include <memory>

#include <fmt/format.h>

#include "jounce/base/units.hpp"
#include "jounce/design/cam_check.hpp"
#include "jounce/design/check_text.hpp"
#include "jounce/design/path_text.hpp"

#include "cli/common/input.hpp"
#include "cli/common/json.hpp"
#include "cli/common/option_names.hpp"
#include "cli/common/verb.hpp"

namespace jounce::cli {
namespace {

struct CheckArguments {
  std::string file;
  std::string axis, machine;
  std::vector<std::string> limits;
  std::string slave, master,
      master_velocity;  ///< state at the start of a coupling; units may be omitted
  int continuity = 1;
  bool json = false;
};

/// Sets a limit from the command line, `velocity=3` or `velocity="3 mm/s"`, in place of the limit of the spec.
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
    *target = under_option("--limit " + key, [&] {
      return quantity(text.substr(equals + 1), labels.unit_of(quantity_name));
    });
    return;
  }
  std::string known;
  for (const auto& [name, target] : all) known += (known.empty() ? "" : ", ") + name;
  throw InputError("--limit", text, "must be KEY=VALUE with one of " + known);
}

void set_limits(Input& input, const CheckArguments& options) {
  for (const auto& text : options.limits) set_limit(input.limits, text, input.labels);
  try {
    require_valid(input.limits);
  } catch (const InputError& error) {
    throw InputError("--limit", error.value(), error.key() + " " + error.rule());
  }
}

/// The state at the start of the coupling, from the options.
EngageState engage_state(const Input& input, const CheckArguments& options) {
  const Units& units = input.labels.units;
  EngageState at;
  const auto read = [&](const char* key, const std::string& text, const std::string& unit,
                        std::optional<double>& value) {
    if (text.empty()) return;
    if (!input.spec || !input.spec->coupling)
      throw InputError(key, text, "needs a spec with [coupling]");
    value = under_option(key, [&] { return quantity(text, unit); });
  };
  read("--slave", options.slave, units.position, at.slave);
  read("--master", options.master, units.x, at.master);
  read("--master-velocity", options.master_velocity, rate_unit(units.x, "s", 1),
       at.master_velocity);
  return at;
}

int run_check(const CheckArguments& options) {
  std::vector<Input> inputs = load_program(options.file, options.machine, options.axis);
  for (Input& input : inputs) set_limits(input, options);
  bool ok = true;
  AxisDocuments documents;
  std::optional<PathSummary> path;
  if (const Input& first = inputs.front(); first.plan) path = summary_of(*first.spec, *first.plan);
  if (path && !options.json) fmt::print("{}\n", path_text(*inputs.front().spec, *path));
  const Overlapped* const overlap = inputs.front().overlap.get();
  if (overlap != nullptr && !options.json)
    fmt::print("{}\n", overlap_text(*inputs.front().spec, *overlap));
  for (const Input& input : inputs) {
    Report report = checked(input, options.continuity, engage_state(input, options));
    add_not_limited(report, input);
    ok = ok && report.ok();
    if (options.json)
      documents.emplace_back(input.axis, Json::parse(check_json(report, input)));
    else
      fmt::print("{}", check_text(report, input));
    if (!options.json && &input != &inputs.back()) fmt::print("\n");
  }
  if (options.json) {
    nlohmann::ordered_json document = document_of(std::move(documents));
    if (path)
      document["path"] = nlohmann::ordered_json::parse(path_json(*inputs.front().spec, *path));
    if (overlap != nullptr)
      document["overlap"] =
          nlohmann::ordered_json::parse(overlap_json(*inputs.front().spec, *overlap));
    fmt::print("{}\n", document.dump(1));
  }
  return ok ? fine : finding;
}

}  // namespace

void add_check(CommandLine& line) {
  const auto options = std::make_shared<CheckArguments>();
  const Verb verb = line.verb("check", "Check exact limits and continuity of a spec or a table",
                              "jounce check cam.toml --limit geo_acceleration=0.02");
  verb.option("FILE", options->file, "Spec or table; - is standard input").required();
  verb.option(
          "--limit", options->limits,
          "Limit KEY=VALUE in addition to the limits of the spec, or in place of one; repeatable")
      .one_each();
  verb.axis(options->axis);
  verb.machine(options->machine);
  verb.option("--continuity", options->continuity,
              "Highest derivative that must be continuous: 0 position, 1 velocity, 2 acceleration, "
              "3 jerk")
      .check(whole(0, 3))
      .shown();
  verb.option("--slave", options->slave,
              "Rest position of the slave at the start of the coupling; default: the first value "
              "of the cam");
  verb.option("--master", options->master,
              "Position of the master at that time; default: the start of the cam");
  verb.option("--master-velocity", options->master_velocity,
              "Velocity of the master at that time, per second; default: that of [master]");
  verb.flag("--json", options->json, "All results as JSON, numbers with all digits");
  verb.work([options] { return run_check(*options); });
}

}  // namespace jounce::cli
