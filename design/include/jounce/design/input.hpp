// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "jounce/design/make.hpp"
#include "jounce/io/table_file.hpp"
#include "jounce/report/report_text.hpp"

namespace jounce {

/// An input of the verbs: one axis of a spec, which is made first, or a finished table.
struct Input {
  std::optional<Spec> spec;
  LazyCurve curve;
  TableFile table;
  std::optional<SampleError>
      error;      ///< error of the table against the curve; none if there is no other curve
  Limits limits;  ///< limits of the spec; none for a table
  Labels labels;
  std::string name;           ///< the spec's name with the axis', or the file's
  std::string axis;           ///< name if there are several axes; otherwise ""
  TableOptions options = {};  ///< by which the table was made
  std::optional<DriveSpec> drive = {};
  std::vector<Residual> residuals = {};
  std::vector<SyncZone> zones = {};
  std::optional<Binding> binding = {};    ///< binding of a table of fewest knots
  std::vector<std::string> unread = {};   ///< other content of its file
  std::shared_ptr<const Plan> plan = {};  ///< plan of a spec of kind "path", shared by its axes
  std::shared_ptr<const Overlapped> overlap = {};  ///< instead of a plan: lines that overlap
  /// Units for velocity, acceleration and jerk in pictures; "": unit_of() of the labels.
  std::array<std::string, 3> rate_units = {};
};

/// Calls `act` with the input's curve, or with its table if there is no other curve: the table
/// needs less time and memory.
template <class Act>
auto of_motion(const Input& input, const Act& act) {
  return input.error ? std::visit(act, *input.curve) : act(input.table.table);
}

/// Positions of slave and master at the start of a coupling. By default, the slave rests at the
/// cam's first value; the master is at the start of the cam, at the velocity of [master] (0 without
/// one).
struct EngageState {
  std::optional<double> slave = {};            ///< u
  std::optional<double> master = {};           ///< m
  std::optional<double> master_velocity = {};  ///< m/s
};

/// Everything that can be checked without integration: limits and joints of the curve, the table's
/// error, limits that the table alone breaks, the effect of engaging a coupling in the given state,
/// and a [drive] whose loop is unstable.
Report check_all(const Input& input, int continuity = 1, const EngageState& at = {});

/// Adds the peak of each derivative that the input does not limit in [limits] or, over time, in
/// [limits.slave]: notes `unlimited/velocity` and so on, without those that are 0 throughout.
void add_not_limited(Report& report, const Input& input);

/// Adds the warning `warning/no_limits` to a report that compares the motion with no limit of the machine.
void add_no_limits(Report& report);

/// Greatest permitted error of the table, in the unit of the position: the requested tolerance; for
/// a requested number of intervals, a millionth of the stroke; for a requested number of knots, the
/// actual error. None if there is no curve besides the table.
std::optional<double> table_tolerance(const Input& input);

/// Content of a table file, or result of a spec: one input for each axis. `path` names it if the
/// spec has no name.
Input input_of(TableFile file, const std::string& path);
std::vector<Input> inputs_of(const Spec& spec, const std::string& path);

/// Reads a spec, a table file or a table in the format of a controller (exchange.hpp), recognized by its content; "-"
/// is standard input. One input for each axis of a spec, or for each cam of a file. `decimal_comma` reads 0,5 as 0.5 in
/// a controller's table. Throws InputError with file, line, key, value and rule.
std::vector<Input> read_inputs(const std::string& path, bool decimal_comma = false);
/// True if the text is a table of Jounce or of a controller.
bool is_finished_table(const std::string& text);
/// The same for the text of such a table.
std::vector<Input> table_inputs(const std::string& text, const std::string& path,
                                bool decimal_comma = false);

/// A G-code program on a machine: `machine` is a path spec without commands, `path` the program. One input for each
/// axis. Throws InputError, placed.
std::vector<Input> gcode_inputs(const std::string& path, const std::string& machine);

}  // namespace jounce
