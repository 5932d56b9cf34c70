// SPDX-License-Identifier: Apache-2.0
#include <memory>

#include <fmt/format.h>

#include "jounce/design/files/file_check.hpp"

#include "cli/common/input.hpp"
#include "cli/common/json.hpp"
#include "cli/common/option_names.hpp"
#include "cli/common/verb.hpp"
#include "cli/verbs/check_run.hpp"

namespace jounce::cli {
namespace {

struct CheckArguments {
  CheckRun run;
  std::string axis, machine, over;
  std::vector<std::string> limits;
  EngageTexts start;
  int continuity = 1;
};

/// The report of one axis, with the limits and the start of the options.
Report report_of(Input& input, const CheckArguments& options) {
  try {
    set_limits(input.limits, options.limits, input.labels);
  } catch (const InputError& error) {
    throw InputError("--" + error.key(), error.value(), error.rule());
  }
  return axis_report(input, options.continuity,
                     with_option_names({"slave", "master", "master_velocity"},
                                       [&] { return engage_state(input, options.start); }));
}

std::vector<Report> reports_of(std::vector<Input>& axes, const CheckArguments& options) {
  std::vector<Report> reports;
  for (Input& axis : axes) reports.push_back(report_of(axis, options));
  return reports;
}

/// The whole answer for one file.
int print_answer(const CheckArguments& options) {
  std::vector<Input> axes =
      over(options.over, load_program(options.run.file(), options.machine, options.axis));
  const FileCheck check = file_check(axes, reports_of(axes, options));
  if (options.run.json)
    print_json(file_check_json(check, axes));
  else
    fmt::print("{}", file_check_text(check, axes));
  return check.ok(options.run.strict) ? fine : finding;
}

int run_check(const CheckArguments& options) {
  require_one_file(options.run, "--axis", options.axis);
  require_one_file(options.run, "--over", options.over);
  if (options.run.files.size() == 1 && !options.limits.empty() &&
      is_without_motion(options.run.file()))
    throw InputError("--limit", options.limits.front(),
                     "applies to a motion, but this file has none: leave out --limit");
  if (options.run.is_one_answer())
    return answer(options.run, [&] { return print_answer(options); });
  const auto examine = [&](std::vector<Input>& axes) { return reports_of(axes, options); };
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
  verb.over(options->over);
  verb.option("--continuity", options->continuity,
              "Highest derivative that must be continuous: 0 position, 1 velocity, 2 acceleration, "
              "3 jerk")
      .check(whole(0, 3))
      .shown();
  verb.option("--slave", options->start.slave,
              "For a spec with [coupling]: position of the slave, at rest, when it starts to "
              "engage; default: the first value of the cam");
  verb.option("--master", options->start.master,
              "For a spec with [coupling]: position of the master when the slave starts to engage; "
              "default: the start of the cam");
  verb.option("--master-velocity", options->start.master_velocity,
              "For a spec with [coupling]: velocity of the master, per second, when the slave "
              "starts to engage; default: the velocity in [master]");
  verb.work([options] { return run_check(*options); });
}

}  // namespace jounce::cli
