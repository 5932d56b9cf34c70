// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "jounce/design/input.hpp"
#include "jounce/stream/sender/banks.hpp"
#include "jounce/stream/sender/row_plan.hpp"
#include "jounce/stream/sender/stream_plan.hpp"

/// Plans for a streamer, made from the inputs of a design. A plan sends whole tables, the rows of
/// one long table, or tables in two banks.
namespace jounce {

/// Options for playing an input on an axis.
struct PlayOptions {
  bool live = false;  ///< true: the cam follows the live master of the axis
  /// Motion of a virtual master over time; nullopt: [master] of the spec.
  std::optional<TableFile> master = {};
  /// True: a live cam takes over at the end of the present pass, at any position of the master.
  bool at_next_cut = false;
  /// True: a live cam begins at a position of the master. If the slave is an angle that advances in
  /// each pass, as for a rotary knife, the axis shifts the cam by whole passes.
  bool at_master = false;
  /// True: at the end of a live cam, the axis keeps its velocity instead of braking.
  bool keep_velocity = false;
};

/// Returns the plan that plays this input on the axis `executor`. Throws InputError (key "live" or
/// "master") for a table that does not suit the options.
StreamPlan stream_plan(const std::string& executor, const Input& input, const PlayOptions& options);

/// Adds an input to the plan. The motion of the input takes over at the end of the previous motion,
/// without a stop.
void add_swap(StreamPlan& plan, const Input& input, const PlayOptions& options);

/// True for a spec of kind "follow". An axis plays such a spec from two banks on its live master;
/// see follow_bank_plan().
bool is_follow(const Input& input);
/// Returns the position of the live master at which a follow spec begins; nullopt if it begins at
/// once.
std::optional<double> pass_position(const Input& input);

/// Returns the plan for a follow spec: its tables, passes and event in two banks. If `relative` is
/// true, positions count from the position of the axis.
BankPlan follow_bank_plan(const Input& input, bool relative);

/// Returns the table of an input for a bank: a table over a master unchanged, a table over time in
/// s.
TableFile bank_of(const Input& input);
/// The rule that `second` breaks, so that one queue cannot contain both tables: another variable, or
/// other units. "" if one queue can contain them. `file`: name of the first table.
std::string queue_conflict(const TableFile& first, const TableFile& second,
                           const std::string& file);
/// Returns the plan that plays the first table once, then the second one `loops` times. If
/// `relative` is true, positions count from the position of the axis.
BankPlan bank_plan(const TableFile& first, const TableFile& second, std::int32_t loops,
                   bool relative);

/// Returns the plan that sends a table over time row by row, in s. The motion starts when `ahead`
/// rows have arrived; the queue holds twice as many. If `relative` is true, positions count from
/// the position of the axis. Throws InputError (key "velocity") for a table that does not end at
/// rest.
RowPlan row_plan(const std::string& executor, TableFile table, std::uint32_t ahead, bool relative);

/// True for the axes of a path of several axes.
bool is_path(const std::vector<Input>& axes);
/// Returns the plan that plays a path on a group: its program, as a list of numbers. Throws
/// InputError for a path that is planned in the joints of a robot, for an override, and for lines
/// that overlap in time.
StreamPlan path_plan(const std::string& group, const std::vector<Input>& axes);
/// Like path_plan(), for a G-code program (file `path`) of several axes and its machine
/// (gcode_spec()). The sender does not plan the path, and makes no tables of its axes. Returns
/// nullopt if `machine` is empty, if the machine has one axis, if `axis` is not empty, and if
/// `path` is standard input.
std::optional<StreamPlan> gcode_path_plan(const std::string& group, const std::string& path,
                                          const std::string& machine, const std::string& axis);

/// Returns the names of a list "x,y,z" of executors. Throws InputError (key "to") for a name that
/// is missing, not possible, or there twice.
std::vector<std::string> executor_names(const std::string& list);
/// Returns the input for each of these executors, from the axes of a file. If the file has one
/// axis, every executor gets it. Otherwise each executor gets the axis of its name or, if the
/// numbers of executors and axes are equal, the axis at its place in the list. `path` is the name
/// of the file for errors. Throws InputError (key "to") if an executor gets no axis.
std::vector<Input> inputs_for(const std::vector<std::string>& executors,
                              const std::vector<Input>& axes, const std::string& path);

/// The names of the options that are given, for a message: "--swap, --live"; "": none.
std::string given_options(const std::vector<std::pair<std::string, bool>>& options);

}  // namespace jounce
