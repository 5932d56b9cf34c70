// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "jounce/report/diagnostic.hpp"

/// A run of many files in the formats of CI systems. Equal runs give equal bytes. Sources: "Workflow commands" and
/// "SARIF support" of the GitHub documentation, SARIF 2.1.0 (OASIS), "Code Quality report format" of the GitLab
/// documentation. JUnit has no standard: Jenkins, GitLab and GitHub read these elements.
namespace jounce {

/// Lines FILE:LINE:COLUMN: SEVERITY: MESSAGE [RULE], as compilers print them; `quiet`: without the warnings.
std::string to_text(const RunResult& run, bool quiet = false);

/// "40 files: 38 good, 1 with broken limits, 1 wrong; 3 warnings".
std::string summary_line(const RunResult& run);

/// {"ok": ..., "status": ..., "files": [{"file": ..., "findings": [...]}]}, every number in full. It contains every
/// finding, those that hold included. A number that is not finite is null.
std::string to_json(const RunResult& run, bool strict = false);

/// One file of it: {"file": ..., "kind": ..., "ok": ..., "status": ..., "findings": [...]}.
std::string to_json(const FileResult& file, bool strict = false);

/// GitHub workflow commands, the worst first: GitHub shows ten errors and ten warnings of a step. Notes and limits that
/// hold are left out, here and in the next two formats.
std::string to_github(const RunResult& run, bool quiet = false);

/// GitLab Code Quality.
std::string to_gitlab(const RunResult& run, bool quiet = false);

/// SARIF 2.1.0, with the rules that occur, their meaning and their remedy. The fingerprint of a result does not depend
/// on its line or on its numbers: an alert stays the same alert while the file changes around it.
std::string to_sarif(const RunResult& run, bool quiet = false);

/// JUnit XML: a suite for each file, a case for each rule at each place, those that hold included. Jenkins keeps one
/// failure of a case.
std::string to_junit(const RunResult& run, bool strict = false);

/// The formats of to_format().
const std::vector<std::string>& run_formats();

/// How much of a run is written.
struct RunLook {
  bool strict = false;  ///< a warning counts as a broken limit
  bool quiet = false;   ///< errors and broken limits alone
};

/// The run in one of run_formats(): "text", "json", "github", "gitlab", "sarif", "junit".
std::string to_format(const RunResult& run, const std::string& format, const RunLook& look = {});

}  // namespace jounce
