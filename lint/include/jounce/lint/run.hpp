// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "jounce/lint/accepted.hpp"
#include "jounce/lint/lint.hpp"
#include "jounce/report/detail/ci_formats.hpp"

namespace jounce {

/// Options of lint_run().
struct LintOptions {
  std::string machine = {};      ///< path spec for G-code programs
  ExamineMachine executor = {};  ///< see lint_file()
  std::string baseline = {};     ///< AcceptedVersions to compare with; empty: none
  std::string against = {};      ///< spec with which `examine` compares tables; empty: none
  AcceptedOptions accepted = {};
  std::function<void(double share)> progress = {};  ///< may be empty
};

/// Examined files with their diagnostics, and their changes from the accepted versions.
struct LintedFiles {
  RunResult result = {};
  std::vector<FileChange> changes = {};
};

/// Examines the files for these names (find_files()), and compares them with their accepted
/// versions. `verb` is the verb of the result, such as "check".
///
///     const LintedFiles all = lint_run("check", {"cams"}, examine, {.baseline = "origin/main"});
///     std::cout << run_text(all.result, "sarif");
///
/// Throws InputError for names without a file (key "FILE"), for `against` without a table among the
/// files (key "--against"), and like AcceptedVersions.
LintedFiles lint_run(const std::string& verb, const std::vector<std::string>& names,
                     const Examine& examine, const LintOptions& options = {});

/// Returns to_format() with the paths that this format needs: formats of CI systems need paths
/// relative to the root of the repository.
std::string run_text(RunResult result, const std::string& format, const RunLook& look = {});

/// Writes summary.md into a folder: the changes as Markdown, with their pictures. Creates the
/// folder. `name` is the name of the accepted versions.
void write_summary(const std::string& folder, const std::vector<FileChange>& changes,
                   const std::string& name);

}  // namespace jounce
