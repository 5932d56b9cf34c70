// SPDX-License-Identifier: Apache-2.0
#include <memory>

#include <fmt/format.h>

#include "jounce/design/detail/file_check.hpp"
#include "jounce/lint/find_files.hpp"

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
  CheckOptions check;
};

std::vector<Report> reports_of(std::vector<Input>& axes, CheckArguments options) {
  options.check.tolerances = options.run.tolerances;
  options.check.against = options.run.against;
  options.check.axis = options.axis;
  options.check.selects_tables = options.run.files.size() > 1 || !is_one_file(options.run.file());
  return with_option_names(
      {"axis", "slave", "master", "master_velocity", "against", "tolerance", "limit"},
      [&] { return check_reports(axes, options.check); });
}

/// The whole answer for one file.
int print_answer(const CheckArguments& options) {
  std::vector<Input> axes =
      over(options.over, load_program(options.run.file(), options.machine,
                                      options.run.against.empty() ? options.axis : ""));

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
  if (!options.run.tolerances.empty() && options.run.baseline.empty() &&
      options.run.against.empty())
    throw InputError("--tolerance", options.run.tolerances.front(),
                     "needs --baseline or --against: add one, or leave out --tolerance");
  if (options.run.files.size() == 1 && !options.check.limits.empty() &&
      is_without_motion(options.run.file()))
    throw InputError("--limit", options.check.limits.front(),
                     "applies to a motion, but this file has none: leave out --limit");
  if (options.run.is_one_answer())
    return answer(options.run, [&] { return print_answer(options); });
  return check_files(
      "check", options.run, [&](auto& axes) { return reports_of(axes, options); }, options.machine);
}

}  // namespace

void add_check(CommandLine& line) {
  const auto options = std::make_shared<CheckArguments>();
  const Verb verb = line.verb("check", "Check exact limits and continuity of specs and tables",
                              "jounce check cam.toml --limit geo_acceleration=0.02\n"
                              "jounce check . --format github --baseline origin/main");
  add_run_options(verb, options->run, true);
  verb.option(
          "--limit", options->check.limits,
          "Limit KEY=VALUE to add to the limits of the spec, or to replace one of them; of a cam, "
          "velocity, acceleration and jerk are over time, see --master-velocity; repeatable")
      .one_each();
  verb.axis(options->axis);
  verb.machine(options->machine);
  verb.over(options->over);
  verb.option("--continuity", options->check.continuity,
              "Highest derivative that must be continuous: 0 position, 1 velocity, 2 acceleration, "
              "3 jerk")
      .check(whole(0, 3))
      .shown();
  verb.option("--slave", options->check.start.slave,
              "For a spec with [coupling]: position of the slave, at rest, when it starts to "
              "engage; default: the first value of the cam");
  verb.option("--master", options->check.start.master,
              "For a spec with [coupling]: position of the master when the slave starts to engage; "
              "default: the start of the cam");
  verb.option("--master-velocity", options->check.start.master_velocity,
              "Velocity of the master, per second, for the limits of a cam over time, or when the "
              "slave of a [coupling] starts to engage; default: [master]");
  verb.work([options] { return run_check(*options); });
}

}  // namespace jounce::cli
