// SPDX-License-Identifier: Apache-2.0
#include "cli/verbs/check_run.hpp"

#include <algorithm>
#include <filesystem>
#include <iterator>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "jounce/base/file.hpp"
#include "jounce/base/input_errors.hpp"
#include "jounce/base/printable.hpp"
#include "jounce/lint/accepted.hpp"
#include "jounce/lint/find_files.hpp"
#include "jounce/report/ci_formats.hpp"

#include "cli/common/progress.hpp"
#include "cli/common/tolerance_option.hpp"

namespace jounce::cli {
namespace {

std::vector<std::string> files_of(const CheckRun& run) {
  const bool in_folder = !run.baseline.empty() && std::filesystem::is_directory(run.baseline);
  std::vector<std::string> files = find_files(run.files, in_folder ? run.baseline : "");
  if (files.empty())
    throw InputError(
        "FILE", fmt::format("{}", fmt::join(run.files, " ")),
        "contains no file of Jounce: name a spec with `jounce = 1`, a table, or a key file");
  return files;
}

/// Adds what the comparison with the accepted versions found to the results of the files.
void add_changes(RunResult& result, const std::vector<FileChange>& changes) {
  for (std::size_t i = 0; i < changes.size(); ++i) {
    if (i >= result.files.size()) result.files.push_back({changes[i].diagnostics[0].place.file});
    auto& all = result.files[i].diagnostics;
    all.insert(all.end(), changes[i].diagnostics.begin(), changes[i].diagnostics.end());
    sort(all);
  }
}

/// Writes the Markdown summary with its pictures into the folder of --summary.
void write_summary(const std::string& folder, const std::vector<FileChange>& changes,
                   const std::string& name) {
  std::error_code none;
  std::filesystem::create_directories(folder, none);
  const auto in_folder = [&](const std::string& file) {
    return (std::filesystem::path(folder) / file).string();
  };
  std::vector<Output> outputs{{in_folder("summary.md"), to_markdown(changes, name)}};
  for (const FileChange& change : changes)
    for (const Output& picture : change.files)
      outputs.push_back({in_folder(picture.path), picture.bytes});
  write_files(outputs);
}

std::vector<FileChange> compared(const CheckRun& run, const std::vector<std::string>& files) {
  const AcceptedVersions accepted(run.baseline);
  AcceptedOptions options;
  options.pictures = !run.summary.empty();
  options.tolerance = [&](const Labels& labels) { return tolerance_of(run.tolerances, labels); };
  auto changes = compare_with(accepted, files, run.files, options);
  if (!run.summary.empty()) write_summary(run.summary, changes, run.baseline);
  return changes;
}

/// Paths as CI systems need them: relative to the root of the repository.
void use_repository_paths(RunResult& result) {
  for (FileResult& file : result.files) {
    file.file = repository_path(file.file);
    for (Diagnostic& each : file.diagnostics)
      for (std::string* path : {&each.place.file, &each.limit_place.file})
        if (!path->empty()) *path = repository_path(*path);
  }
}

std::string text_of(RunResult result, const CheckRun& run) {
  const std::string format = run.json ? "json" : run.format;
  if (format == "github" || format == "gitlab" || format == "sarif") use_repository_paths(result);
  if (format == "json") return to_json(result, run.strict);
  if (format == "github") return to_github(result, run.quiet);
  if (format == "gitlab") return to_gitlab(result, run.quiet);
  if (format == "sarif") return to_sarif(result, run.quiet);
  if (format == "junit") return to_junit(result, run.strict);
  return to_text(result, run.quiet);
}

}  // namespace

bool CheckRun::is_one_answer() const {
  return files.size() == 1 && is_one_file(file()) && format == "text" && !quiet &&
         baseline.empty() && !is_without_motion(file());
}

void add_run_options(const Verb& verb, CheckRun& run) {
  verb.option("FILE", run.files,
              "Specs and tables. A folder, or a pattern in quotes such as \"cams/**/*.toml\", "
              "means all files of Jounce in it; - is standard input")
      .required();
  const Option format = verb.option("--format", run.format,
                                    "Format of the answer for several files: text, json, github "
                                    "(annotations), gitlab (Code Quality), sarif, junit")
                            .check(one_of({"text", "json", "github", "gitlab", "sarif", "junit"}))
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
  verb.option("--tolerance", run.tolerances, tolerance_help).one_each().needs(baseline);
  verb.option("--summary", run.summary,
              "Folder for a new summary.md, with pictures of each changed motion before and after")
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
  const std::vector<std::string> files = files_of(run);
  RunResult result{verb, {}};
  {
    Progress line(verb);
    result.files = lint_files(files, examine, machine, [&](double share) { line.show(share); });
  }
  const bool is_log = !run.json && (run.format == "text" || run.format == "github");
  std::FILE* beside = is_log ? stdout : stderr;
  std::string comparison;
  if (!run.baseline.empty()) {
    const auto changes = compared(run, files);
    add_changes(result, changes);
    comparison = to_text(changes, run.baseline);
  }
  fmt::print("{}", text_of(result, run));
  if (!run.quiet) fmt::print(beside, "{}{}\n", comparison, summary_line(result));
  return result.status(run.strict);
}

void require_one_file(const CheckRun& run, const char* option, const std::string& value) {
  if (!value.empty() && !run.is_one_answer())
    throw InputError(option, value, "applies to a single file, with the answer as text or --json");
}

}  // namespace jounce::cli
