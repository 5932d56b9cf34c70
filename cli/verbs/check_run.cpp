// SPDX-License-Identifier: Apache-2.0
#include "cli/verbs/check_run.hpp"

#include <fmt/format.h>

#include "jounce/base/detail/printable.hpp"
#include "jounce/base/detail/progress_line.hpp"
#include "jounce/base/input_errors.hpp"
#include "jounce/lint/find_files.hpp"
#include "jounce/lint/run.hpp"
#include "jounce/machine/machine_parts.hpp"
#include "jounce/report/comparison.hpp"
#include "jounce/report/detail/ci_formats.hpp"

#include "cli/common/option_names.hpp"

namespace jounce::cli {
bool CheckRun::is_one_answer() const {
  return files.size() == 1 && is_one_file(file()) && format == "text" && !quiet &&
         baseline.empty() && !is_without_motion(file());
}

void add_run_options(const Verb& verb, CheckRun& run, bool of_tables) {
  verb.option("FILE", run.files,
              "Specs and tables. A folder, or a pattern in quotes such as \"cams/**/*.toml\", "
              "means all files of Jounce in it; - is standard input")
      .required();
  const Option format = verb.option("--format", run.format,
                                    "Format of the answer for several files: text, json, github "
                                    "(annotations), gitlab (Code Quality), sarif, junit")
                            .check(one_of(run_formats()))
                            .shown();
  verb.flag("--json", run.json,
            "All results of one file as JSON, numbers with all digits; for several files, use "
            "--format json")
      .excludes({format});
  verb.flag("--strict", run.strict, "Exit with status 1 for a warning, too");
  verb.flag("--quiet", run.quiet, "Print errors and broken limits only: no warnings, no summary");
  const Option baseline = verb.option(
      "--baseline", run.baseline,
      "Accepted versions to compare with: a folder of specs or tables, or a git revision");
  const Option tolerance = verb.option("--tolerance", run.tolerances, tolerance_help).one_each();
  if (!of_tables)
    tolerance.needs(baseline);
  else
    verb.option("--against", run.against,
                "Spec of the tables: compares each table with its curve and all of its limits; of "
                "several files, those whose header names this spec or none")
        .excludes({baseline});
  verb.option("--summary", run.summary,
              "Folder for a new summary.md, with pictures of each changed motion before and after")
      .check(output_folder())
      .needs(baseline);
}

int answer(const CheckRun& run, const std::function<int()>& work) {
  try {
    return work();
  } catch (const InputError& error) {
    FileResult result{run.file(), {}, diagnostics_of(error, run.file())};
    if (run.json) fmt::print("{}", to_json(result));
    for (const InputError& one : all_errors(error))
      fmt::print(stderr, "jounce: {}\n", printable_lines(one.what()));
    return bad_input;
  }
}

int check_files(const std::string& verb, const CheckRun& run, const Examine& examine,
                const std::string& machine) {
  LintedFiles all;
  {
    ProgressLine line(verb);
    all = with_option_names({"tolerance"}, [&] {
      return lint_run(verb, run.files, examine,
                      {.machine = machine,
                       .executor = {.axis = require_axis, .machine = require_machine},
                       .baseline = run.baseline,
                       .against = run.against,
                       .accepted = {.tolerances = run.tolerances, .pictures = !run.summary.empty()},
                       .progress = [&](double share) { line.show(share); }});
    });
  }
  if (!run.summary.empty()) write_summary(run.summary, all.changes, run.baseline);
  const std::string format = run.json ? "json" : run.format;
  fmt::print("{}", run_text(all.result, format, {run.strict, run.quiet}));
  std::FILE* beside = format == "text" || format == "github" ? stdout : stderr;
  if (!run.quiet)
    fmt::print(beside, "{}{}\n", run.baseline.empty() ? "" : to_text(all.changes, run.baseline),
               summary_line(all.result));
  return all.result.status(run.strict);
}

void require_one_file(const CheckRun& run, const char* option, const std::string& value) {
  if (value.empty() || run.is_one_answer()) return;
  if (run.files.size() > 1 || !is_one_file(run.file()))
    throw InputError(option, value, "applies to a single file: give one file, or leave it out");
  for (const auto& [other, given] : {std::pair{"--format", run.format != "text"},
                                     {"--quiet", run.quiet},
                                     {"--baseline", !run.baseline.empty()}})
    if (given)
      throw InputError(option, value,
                       std::string("cannot be combined with ") + other + ": leave out one of them");
  throw InputError(option, value, "applies to a motion, but this file has none: leave it out");
}

}  // namespace jounce::cli
