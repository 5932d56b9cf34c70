// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "jounce/lint/lint.hpp"

#include "cli/common/verb.hpp"

namespace jounce::cli {

/// Help of --tolerance.
inline constexpr const char* tolerance_help =
    "Differences up to this tolerance count as equal: a share of the range of each quantity "
    "(1e-6), or KEY=VALUE for one quantity (position=0.01); repeatable; default: rounding errors "
    "only";

/// The options of the verbs that check files: which files, and how to report them.
struct CheckRun {
  std::vector<std::string> files;
  std::string format = "text";
  std::string baseline, against;
  std::vector<std::string> tolerances;
  std::string summary;
  bool json = false;
  bool strict = false;
  bool quiet = false;

  /// True for one file whose whole answer is printed: extrema of each segment, all findings.
  [[nodiscard]] bool is_one_answer() const;
  /// The only file of is_one_answer().
  [[nodiscard]] const std::string& file() const { return files.front(); }
};

/// `of_tables`: true for a verb with --against.
void add_run_options(const Verb& verb, CheckRun& run, bool of_tables = false);

/// The work for one answer. It prints all errors of the file; with --json they are on standard output as well.
int answer(const CheckRun& run, const std::function<int()>& work);

/// Checks all files and prints them in the format of the run. `machine`: the path spec of G-code programs.
int check_files(const std::string& verb, const CheckRun& run, const Examine& examine,
                const std::string& machine = "");

/// Throws InputError for a value of an option that is for one file, if the run is not.
void require_one_file(const CheckRun& run, const char* option, const std::string& value);

}  // namespace jounce::cli
