// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "jounce/executor/axis_server.hpp"
#include "jounce/executor/masters.hpp"

namespace jounce {

/// The specs of a machine, and how its axes run.
struct MachineOptions {
  std::vector<std::string> files = {};  ///< specs of kind "axis", or one of kind "machine"
  std::string log = {};                 ///< tick log, see log_of(); empty: none
  bool adopt_start = false;             ///< ExecutorOptions::adopt_start
  bool finish_when_silent = false;      ///< not ExecutorOptions::stop_when_silent
  bool enable = false;                  ///< ExecutorOptions::enable
  std::function<void(const std::string& notice)> notify =
      {};  ///< the axes' notices, with their name if there are several
};

/// The log of one axis: run.csv of one, run.feeder.csv, run.knife.csv of several.
std::string log_of(const std::string& log, const std::string& axis, std::size_t axes);

/// The axes and masters of one executor.
struct MachineParts {
  std::vector<ExecutorOptions> axes = {};  ///< masters that play a table are the last of them
  std::vector<MachineMaster> masters = {};
  std::optional<double> watchdog = {};  ///< s, as RunOptions::watchdog, if the spec has one
};

/// The axes and masters of the specs:
///
///     auto [axes, masters, watchdog] = machine_parts({.files = {"machine.toml"}});
///     run_executor(*link, axes, {.masters = masters});
///
/// Throws InputError, with file, line and key if there is one, for a file of another kind, a bad
/// configuration, a leader that does not exist, and different units. Throws std::system_error if
/// there is no shared memory for a drive.
MachineParts machine_parts(const MachineOptions& options);

}  // namespace jounce
