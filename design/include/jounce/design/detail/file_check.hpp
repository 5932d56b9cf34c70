// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "jounce/design/detail/path_text.hpp"
#include "jounce/design/input.hpp"

namespace jounce {

/// Sets limits from texts such as "velocity=3" and "geo_velocity=3 mm/deg", each in place of the
/// limit of the spec. Throws InputError with the key "limit" for a text that names no limit, and
/// "limit NAME" for a bad number and for limits that contradict each other.
void set_limits(Limits& limits, const std::vector<std::string>& texts, const Labels& labels);

/// Texts of an EngageState, with or without a unit; empty: the default.
struct EngageTexts {
  std::string slave = {};
  std::string master = {};
  std::string master_velocity = {};
};
/// Returns the state that the texts describe. Throws InputError, with the name of the member as
/// key, for a text that is not a quantity in the unit of the member, and for an input without a
/// spec with [coupling].
EngageState engage_state(const Input& input, const EngageTexts& texts);

/// Returns the report of `jounce check` for one axis: the report of checked() (cam_check.hpp), the
/// peaks without a limit, and a warning if no limits are given.
Report axis_report(const Input& input, int continuity = 1, const EngageState& at = {});

/// Options of check_reports().
struct CheckOptions {
  /// Limits as for set_limits(). For a cam, "velocity=...", "acceleration=..." and "jerk=..." limit
  /// the slave over time, behind a master at the velocity of [master] or of `start`.
  std::vector<std::string> limits = {};
  EngageTexts start = {};    ///< start of a coupling; master_velocity: also for limits over time
  int continuity = 1;        ///< highest derivative that must be continuous
  std::string against = {};  ///< spec of the tables, see set_against(); "": none
  /// For `against`: the axis of this spec for a table without a name; for several tables, the one
  /// to check. "": the name of the file determines the axis; all tables are checked.
  std::string axis = {};
  /// Tolerances for `against`, as for tolerance_of()
  std::vector<std::string> tolerances = {};
  /// For a check of many files. True: `against` applies to the tables whose header names this spec
  /// or no spec, and specs are checked without `against`. False: `against` applies to the file,
  /// which must be a table.
  bool selects_tables = false;
};

/// Returns the report of `jounce check` for each axis of a file: axis_report(), with the limits and
/// the spec of the options. The axes receive these limits and this spec. Throws InputError like
/// set_limits(), set_against() and engage_state().
std::vector<Report> check_reports(std::vector<Input>& axes, const CheckOptions& options);

/// The check of all axes of a file, and of the path that they follow.
struct FileCheck {
  std::vector<Report> reports = {};      ///< one for each axis
  std::optional<PathSummary> path = {};  ///< if the axes have a plan

  /// True if no limit is broken. `strict` counts a warning as a broken limit.
  [[nodiscard]] bool ok(bool strict = false) const;
};
/// Returns the check of a file. `reports`: one report for each axis, such as axis_report().
FileCheck file_check(const std::vector<Input>& axes, std::vector<Report> reports);

/// Returns the answer of `jounce check`: path_text() or overlap_text() if the axes follow a path,
/// then check_text() of each axis.
std::string file_check_text(const FileCheck& check, const std::vector<Input>& axes);
/// Returns the answer as a JSON object: the objects that check_json() returns for the axes,
/// combined by axes_json(), and a member "path" or "overlap" if the axes follow a path.
std::string file_check_json(const FileCheck& check, const std::vector<Input>& axes);

}  // namespace jounce
