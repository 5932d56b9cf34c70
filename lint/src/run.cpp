// SPDX-License-Identifier: Apache-2.0
#include "jounce/lint/run.hpp"

#include <filesystem>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "jounce/base/file.hpp"
#include "jounce/lint/find_files.hpp"
#include "jounce/profiles/error.hpp"

namespace jounce {
namespace {

/// The files to examine, without those of a folder of accepted versions.
std::vector<std::string> files_of(const std::vector<std::string>& names,
                                  const std::string& baseline) {
  const bool in_folder = !baseline.empty() && std::filesystem::is_directory(baseline);
  std::vector<std::string> files = find_files(names, in_folder ? baseline : "");
  if (!files.empty()) return files;
  const std::string given = fmt::format("{}", fmt::join(names, " "));
  if (in_folder && !find_files(names).empty())
    throw InputError("FILE", given,
                     "contains only files of the accepted versions, " + baseline +
                         ", and a file is not compared with itself: give another folder, or a git "
                         "revision, with --baseline");
  if (const std::size_t programs = gcode_files(names).size(); programs > 0)
    throw InputError("FILE", given,
                     "contains no Jounce files, but G-code programs (" + std::to_string(programs) +
                         "): name each program, with --machine SPEC");
  throw InputError(
      "FILE", given,
      "contains no Jounce files: give a spec (a file with jounce = 1), a table or a key file");
}

/// Throws if none of the files is a table, which could be compared with a spec.
void require_table(const RunResult& result, const std::string& against) {
  if (against.empty()) return;
  for (const FileResult& file : result.files)
    if (file.kind == "table" || file.kind.empty()) return;  // a file with errors has its own
  throw InputError(
      "--against", against,
      "is the spec of tables, but none of the files is a table: name a table, or leave "
      "out --against; `jounce diff` compares two specs");
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

/// Paths as CI systems need them: relative to the root of the repository.
void use_repository_paths(RunResult& result) {
  for (FileResult& file : result.files) {
    file.file = repository_path(file.file);
    for (Diagnostic& each : file.diagnostics)
      for (std::string* path : {&each.place.file, &each.limit_place.file})
        if (!path->empty()) *path = repository_path(*path);
  }
}

}  // namespace

LintedFiles lint_run(const std::string& verb, const std::vector<std::string>& names,
                     const Examine& examine, const LintOptions& options) {
  const std::vector<std::string> files = files_of(names, options.baseline);
  LintedFiles all{
      {verb, lint_files(files, examine, options.machine, options.progress, options.executor)}};
  require_table(all.result, options.against);
  all.result.skipped = controller_files(names).size();
  all.result.programs = gcode_files(names).size();
  if (options.baseline.empty()) return all;
  const AcceptedVersions accepted(options.baseline);
  all.changes = compare_with(accepted, files, names, options.accepted);
  add_changes(all.result, all.changes);
  return all;
}

std::string run_text(RunResult result, const std::string& format, const RunLook& look) {
  if (format == "github" || format == "gitlab" || format == "sarif") use_repository_paths(result);
  return to_format(result, format, look);
}

void write_summary(const std::string& folder, const std::vector<FileChange>& changes,
                   const std::string& name) {
  std::error_code failed;
  std::filesystem::create_directories(folder, failed);
  if (failed)
    throw InputError("--summary", folder,
                     "cannot be made: " + failed.message() + ": name another folder");
  const auto in_folder = [&](const std::string& file) {
    return (std::filesystem::path(folder) / file).string();
  };
  std::vector<Output> outputs{{in_folder("summary.md"), to_markdown(changes, name)}};
  std::vector<std::string> inputs;
  for (const FileChange& change : changes) {
    inputs.insert(inputs.end(), change.inputs.begin(), change.inputs.end());
    for (const Output& picture : change.files)
      outputs.push_back({in_folder(picture.path), picture.bytes});
  }
  write_files(outputs, inputs);
}

}  // namespace jounce
