// SPDX-License-Identifier: Apache-2.0
#include <memory>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "jounce/base/nearest.hpp"
#include "jounce/base/units.hpp"
#include "jounce/design/cam_check.hpp"
#include "jounce/design/check_text.hpp"
#include "jounce/design/path_text.hpp"

#include "cli/common/input.hpp"
#include "cli/common/json.hpp"
#include "cli/common/option_names.hpp"
#include "cli/common/verb.hpp"
#include "cli/verbs/check_run.hpp"

namespace jounce::cli {
namespace {

struct CheckArguments {
  CheckRun run;
  std::string axis, machine;
  std::vector<std::string> limits;
  std::string slave, master,
      master_velocity;  ///< state at the start of a coupling; units may be omitted
  int continuity = 1;
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
  std::vector<std::string> known;
  for (const auto& [name, target] : all) known.push_back(name);
  const std::string near = nearest(key, known);
  throw InputError(
      "--limit", text,
      fmt::format("must be KEY=VALUE with one of the keys {}{}", fmt::join(known, ", "),
                  near.empty() || near == key ? "" : ": did you mean " + near + "?"));
}

void set_limits(Input& input, const CheckArguments& options) {
  for (const auto& text : options.limits) set_limit(input.limits, text, input.labels);
  try {
    require_valid(input.limits);
  } catch (const InputError& error) {
    throw InputError("--limit " + error.key(), error.value(), error.rule());
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

Report report_of(const Input& input, const CheckArguments& options) {
  Report report = checked(input, options.continuity, engage_state(input, options));
  add_not_limited(report, input);
  if (!input.plan) add_no_limits(report);  // the plan of a path keeps the limits of the path
  return report;
}

/// The whole answer for one file.
int print_answer(const CheckArguments& options) {
  const bool json = options.run.json;
  std::vector<Input> inputs = load_program(options.run.file(), options.machine, options.axis);
  for (Input& input : inputs) set_limits(input, options);
  AxisDocuments documents;
  std::optional<PathSummary> path;
  if (const Input& first = inputs.front(); first.plan) path = summary_of(*first.spec, *first.plan);
  bool ok = !path || path->along.ok();
  if (path && !json) fmt::print("{}\n", path_text(*inputs.front().spec, *path));
  const Overlapped* const overlap = inputs.front().overlap.get();
  if (overlap != nullptr && !json) fmt::print("{}\n", overlap_text(*inputs.front().spec, *overlap));
  for (const Input& input : inputs) {
    const Report report = report_of(input, options);
    ok = ok && report.ok() && (!options.run.strict || report.warnings() == 0);
    if (json)
      documents.emplace_back(input.axis, Json::parse(check_json(report, input)));
    else
      fmt::print("{}", check_text(report, input));
    if (!json && &input != &inputs.back()) fmt::print("\n");
  }
  if (json) {
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

int run_check(const CheckArguments& options) {
  require_one_file(options.run, "--axis", options.axis);
  if (options.run.is_one_answer())
    return answer(options.run, [&] { return print_answer(options); });
  const auto examine = [&](std::vector<Input>& axes) {
    std::vector<Report> reports;
    for (Input& axis : axes) {
      set_limits(axis, options);
      reports.push_back(report_of(axis, options));
    }
    return reports;
  };
  return check_files("check", options.run, examine, options.machine);
}

}  // namespace

void add_check(CommandLine& line) {
  const auto options = std::make_shared<CheckArguments>();
  const Verb verb = line.verb("check", "Check exact limits and continuity of specs and tables",
                              "jounce check cam.toml --limit geo_acceleration=0.02\n"
                              "jounce check . --format github --baseline origin/main");
  add_run_options(verb, options->run);
  verb.option(
          "--limit", options->limits,
          "Limit KEY=VALUE to add to the limits of the spec, or to replace one of them; repeatable")
      .one_each();
  verb.axis(options->axis);
  verb.machine(options->machine);
  verb.option("--continuity", options->continuity,
              "Highest derivative that must be continuous: 0 position, 1 velocity, 2 acceleration, "
              "3 jerk")
      .check(whole(0, 3))
      .shown();
  verb.option("--slave", options->slave,
              "For a spec with [coupling]: position of the slave, at rest, when it starts to "
              "engage; default: the first value of the cam");
  verb.option("--master", options->master,
              "For a spec with [coupling]: position of the master when the slave starts to engage; "
              "default: the start of the cam");
  verb.option("--master-velocity", options->master_velocity,
              "For a spec with [coupling]: velocity of the master, per second, when the slave "
              "starts to engage; default: the velocity in [master]");
  verb.work([options] { return run_check(*options); });
}

}  // namespace jounce::cli
