// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "jounce/executor/executor_options.hpp"
#include "jounce/executor/masters.hpp"

namespace jounce::cli {

/// Options of `jounce run` besides the specs.
struct MachineOptions {
  std::vector<std::string> files;  ///< specs of kind "axis", or one of kind "machine"
  std::string log;                 ///< empty: none
  bool adopt_start = false;
  bool finish_when_silent = false;
  bool enable = false;
};

/// The log of one axis: run.csv of one, run.feeder.csv, run.knife.csv of several.
std::string log_of(const std::string& log, const std::string& axis, std::size_t axes);

/// The axes and masters of one executor.
struct MachineParts {
  std::vector<ExecutorOptions> axes = {};  ///< masters that play a table are the last of them
  std::vector<MachineMaster> masters = {};
  std::optional<double> watchdog = {};  ///< s, as RunOptions::watchdog, if the spec has one
};

/// Builds the axes of the specs. Throws InputError, with file, line and key where there is one: a file of another
/// kind, a bad configuration, whom to follow that is not there, other units.
MachineParts parts_of(const MachineOptions& options);

}  // namespace jounce::cli
