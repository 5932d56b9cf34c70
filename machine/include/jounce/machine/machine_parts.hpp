// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "jounce/executor/executor_options.hpp"
#include "jounce/executor/machine_master.hpp"
#include "jounce/executor/recorder_options.hpp"
#include "jounce/spec/machine_spec.hpp"
#include "jounce/spec/spec.hpp"

namespace jounce {

/// The spec files of a machine, and options for all its axes.
struct MachineOptions {
  /// specs of the kind "axis", or one spec of the kind "machine"
  std::vector<std::string> files = {};
  std::string log = {};      ///< name of the tick log, see log_of(); "": none
  bool adopt_start = false;  ///< see ExecutorOptions::adopt_start
  /// True: a motion continues if its session times out (the opposite of
  /// ExecutorOptions::stop_when_silent).
  bool finish_when_silent = false;
  bool enable = false;  ///< see ExecutorOptions::enable
  /// True: opens no drive in shared memory; an ideal drive takes its place.
  bool without_drives = false;
  /// Receives the notices of all axes, with the name of the axis if there are several.
  std::function<void(const std::string& notice)> notify = {};
};

/// Returns the name of the tick log of an axis. With one axis, it is `log` itself; with several,
/// run.feeder.csv, run.knife.csv, ... for the `log` run.csv.
std::string log_of(const std::string& log, const std::string& axis, std::size_t axes);

/// The axes and masters of one executor.
struct MachineParts {
  /// All axes; then virtual masters that play a table; then groups.
  std::vector<ExecutorOptions> axes = {};
  std::vector<MachineMaster> masters = {};  ///< all other masters
  std::optional<double> watchdog = {};      ///< RunOptions::watchdog, s; nullopt: not in the spec
  std::vector<std::string> files = {};      ///< all files that were read

  void add_files(const std::vector<std::string>& more) {
    files.insert(files.end(), more.begin(), more.end());
  }
};

/// Reads the specs of a machine and makes its axes and masters:
///
///     auto [axes, masters, watchdog, files] = machine_parts({.files = {"machine.toml"}});
///     run_executor(*link, axes, {.masters = masters});
///
/// Throws InputError with file, line and key for a file of another kind, an invalid configuration,
/// a group whose program exceeds the limits of its axes, an axis that follows an unknown axis or
/// master, and units that do not match. Throws std::system_error if the shared memory of a drive
/// cannot be created.
MachineParts machine_parts(const MachineOptions& options);

/// Throws InputError, with file, line and key, for a spec of kind "axis" that machine_parts()
/// rejects alone: its limits, homing, sensors and drive. Opens no drive.
void require_axis(const Spec& spec);
/// Throws InputError for a machine that machine_parts() rejects. Opens no drive.
void require_machine(const MachineSpec& spec);

/// Throws InputError (key "log", "record" or "black_box") if a file that the executor would write
/// is one of its specs.
void require_no_specs(const MachineOptions& options, const RecorderOptions& record);
/// Like require_no_specs(), for all files of the machine, including the files that the specs name.
void require_no_inputs(const MachineOptions& options, const RecorderOptions& record,
                       const MachineParts& parts);

}  // namespace jounce
