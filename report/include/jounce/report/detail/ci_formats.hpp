// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "jounce/report/detail/diagnostic.hpp"

/// The result of `jounce check` or `jounce validate` for many files, in the formats of CI systems.
/// Equal results give equal bytes.
///
/// Sources: "Workflow commands" and "SARIF support" of the GitHub documentation; SARIF 2.1.0
/// (OASIS); "Code Quality report format" of the GitLab documentation. JUnit has no standard: these
/// functions write the elements that Jenkins, GitLab and GitHub read.
///
/// `quiet` omits warnings. `strict` counts a warning as a broken limit.
namespace jounce {

/// Returns one line for each diagnostic, in the form that compilers print: FILE:LINE:COLUMN:
/// SEVERITY: MESSAGE [RULE].
std::string to_text(const RunResult& run, bool quiet = false);

/// Returns a summary: "40 files: 38 good, 1 with broken limits, 1 wrong; 3 warnings".
std::string summary_line(const RunResult& run);

/// Returns JSON: {"ok": ..., "status": ..., "files": [{"file": ..., "findings": [...]}]}, with all
/// digits of each number. It contains every finding, including satisfied limits. A number that is
/// not finite is null.
std::string to_json(const RunResult& run, bool strict = false);

/// Returns the JSON of one file: {"file": ..., "kind": ..., "ok": ..., "status": ..., "findings":
/// [...]}.
std::string to_json(const FileResult& file, bool strict = false);

/// Returns GitHub workflow commands, the worst diagnostics first, because GitHub shows only ten
/// errors and ten warnings of a step. This format and the next two omit notes and satisfied limits.
std::string to_github(const RunResult& run, bool quiet = false);

/// Returns a GitLab Code Quality report.
std::string to_gitlab(const RunResult& run, bool quiet = false);

/// Returns SARIF 2.1.0, with the meaning and the remedy of each rule that occurs. The fingerprint
/// of a result depends neither on its line nor on its numbers, so an alert remains the same when
/// other parts of the file change.
std::string to_sarif(const RunResult& run, bool quiet = false);

/// Returns JUnit XML: a suite for each file, and a case for each rule at each place, including
/// satisfied rules. If a case has several failures, Jenkins shows only one of them.
std::string to_junit(const RunResult& run, bool strict = false);

/// Returns the names of the formats of to_format().
const std::vector<std::string>& run_formats();

/// Selection of the findings that the text shows.
struct RunLook {
  bool strict = false;  ///< a warning counts as a broken limit
  bool quiet = false;   ///< only errors and broken limits
};

/// Returns the result in one of run_formats(): "text", "json", "github", "gitlab", "sarif",
/// "junit".
std::string to_format(const RunResult& run, const std::string& format, const RunLook& look = {});

}  // namespace jounce
