// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "jounce/controllers/exchange/exchange_format.hpp"
#include "jounce/design/make.hpp"
#include "jounce/io/table_file.hpp"
#include "jounce/report/report_text.hpp"

namespace jounce {

/// The comparison of a finished table with its spec (set_against() in design/src/input/against_spec.hpp).
struct AgainstSpec {
  std::string spec = {};   ///< path of the spec
  SampleError error = {};  ///< deviation of the table from the curve of the spec
  double tolerance = 0;    ///< greatest permitted deviation of the position
  double digits = 0;       ///< share of a number that the rounding in the file may change
  std::vector<std::string> broken = {};  ///< limits and continuity that the spec breaks, too
  bool limits_only = false;              ///< true: only the limits of the spec apply, not its curve
};

/// The input of a verb such as `jounce check`: one axis of a spec with its curve and table, or a
/// table from a file.
struct Input {
  std::optional<Spec> spec = {};  ///< the spec; nullopt for a table
  LazyCurve curve;  ///< the exact curve; for a table from a file, the curve of this table
  TableFile table;  ///< the table with its units
  /// error of the table against the curve; nullopt if `curve` is the curve of the table
  std::optional<SampleError> error = {};
  Limits limits = {};         ///< limits of the spec; no limits for a table
  Labels labels = {};         ///< names and units for reports
  std::string name = {};      ///< name of the spec with the name of the axis, or name of the file
  std::string axis = {};      ///< name of the axis if there are several; otherwise ""
  TableOptions options = {};  ///< options with which the table was made
  std::optional<DriveSpec> drive = {};  ///< [drive] of the spec
  /// residual vibration of each mode that an operator of [[then]] suppresses
  std::vector<Residual> residuals = {};
  std::vector<SyncZone> zones = {};  ///< intervals in which slave and master are in step
  /// For a table of fewest knots: the requirement that determines their number.
  std::optional<Binding> binding = {};
  std::vector<std::string> unread = {};   ///< content of the file that was not read
  std::shared_ptr<const Plan> plan = {};  ///< for kind "path": the plan, shared by its axes
  /// For kind "path" with overlapping lines: their motion, instead of a plan.
  std::shared_ptr<const Overlapped> overlap = {};
  /// Units for velocity, acceleration and jerk in figures; "": unit_of() of the labels.
  std::array<std::string, 3> rate_units = {};
  /// Bound of the error of the curve itself, which the error of the table includes: the error of
  /// cam operators with a tolerance, and of a slave over time.
  double fit = 0;
  std::string file = {};  ///< path of the file; "-": standard input
  /// All files that were read: the file, and those that it names (Document::files).
  std::vector<std::string> files = {};
  std::string newer_spec = {};  ///< for a table: the spec that its header names, if it has changed
  std::optional<AgainstSpec> against = {};  ///< for a table: its comparison with its spec
  const ExchangeFormat* format = nullptr;   ///< for a table: the format of a controller
};

/// Calls `act` with the motion of an input: its curve or, if `curve` is the curve of the table, its
/// table, which needs less time and memory.
template <class Act>
auto of_motion(const Input& input, const Act& act) {
  return input.error ? std::visit(act, *input.curve) : act(input.table.table);
}

/// Positions of slave and master when a coupling engages. Defaults: the slave rests at the first
/// value of the cam, and the master is at the start of the cam with the velocity of [master] (0
/// without [master]). u is the slave's unit, m the master's.
struct EngageState {
  std::optional<double> slave = {};            ///< u
  std::optional<double> master = {};           ///< m
  std::optional<double> master_velocity = {};  ///< m/s
};

/// Checks everything that needs no integration: the limits and breaks of the curve, the error of
/// the table, limits that only the table breaks, the findings of the generator and of the table's
/// columns, [load], [disc] and [compare], the engagement of a coupling in the state `at`, the ends
/// of a cam that runs once, and the stability of the loop of a [drive].
Report check_all(const Input& input, int continuity = 1, const EngageState& at = {});

/// Adds a note (`unlimited/velocity`, ...) with the peak of each derivative that has no limit in
/// [limits] or, over time, in [limits.slave]. Derivatives that are 0 everywhere get no note.
void add_not_limited(Report& report, const Input& input);

/// Adds the warning `warning/no_limits` if the report compares the motion with no limit of the
/// machine.
void add_no_limits(Report& report, const Spec* spec = nullptr);

/// Returns the greatest permitted error of the table, in the unit of the position: the requested
/// tolerance. If none is requested, it is
/// - the actual error, for a table of fewest knots
/// - a millionth of the stroke, if a number of intervals is requested
/// - a billionth of the stroke otherwise
/// The error of the curve (`fit`) is added. The result is never below rounding. Returns nullopt if
/// `curve` is the curve of the table.
std::optional<double> table_tolerance(const Input& input);

/// Returns the content of a table file as an input.
Input input_of(TableFile file, const std::string& path);
/// Makes the motion of a spec: one input for each axis. If the spec has no name, `path` is used as
/// its name.
std::vector<Input> inputs_of(const Spec& spec, const std::string& path);

/// Reads a spec, a table file, or a table in the format of a controller (exchange.hpp); the content
/// determines the kind. "-" is standard input. Returns one input for each axis of a spec, or for
/// each cam of a file. If `decimal_comma` is true, 0,5 is read as 0.5 in a controller's table.
/// Throws InputError with file, line, key, value and rule.
std::vector<Input> read_inputs(const std::string& path, bool decimal_comma = false);
/// True if the text, of the file `path`, is a table of Jounce or of a controller.
bool is_finished_table(const std::string& text, const std::string& path = "");
/// Like read_inputs(), for the text of a table of Jounce or of a controller.
std::vector<Input> table_inputs(const std::string& text, const std::string& path,
                                bool decimal_comma = false);

/// Returns the files of all inputs.
std::vector<std::string> files_of(std::span<const Input> inputs);

/// Reads a G-code program (file `path`) for a machine (file `machine`: a path spec without
/// commands). Returns one input for each axis. Throws InputError, with the place in the document.
std::vector<Input> gcode_inputs(const std::string& path, const std::string& machine);
/// Like gcode_inputs() for a text that is neither a spec nor a table, if `machine` is not empty;
/// otherwise like read_inputs(). Use it for several files of which some are G-code programs.
std::vector<Input> read_program(const std::string& path, const std::string& machine);
/// Returns the spec from which gcode_inputs() makes the motion.
Spec gcode_spec(const std::string& path, const std::string& machine);

}  // namespace jounce
