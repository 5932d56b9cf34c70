// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "jounce/axis/group_program.hpp"
#include "jounce/axis/machine.hpp"
#include "jounce/executor/cycle.hpp"
#include "jounce/stream/receiver/receiver.hpp"

namespace jounce {

class Recorder;
class Trace;

/// A group of an executor (docs/executor/groups.md).
struct ExecutorGroup {
  AxisGroup of;                                      ///< its axes in the machine
  std::vector<std::string> names;                    ///< names of these axes
  std::vector<AxisConfig> configs;                   ///< configurations of these axes
  std::shared_ptr<const GroupProgram> program = {};  ///< path that StartTable plays; null: none
};

/// Options of one axis, or of one group, of an executor.
struct ExecutorOptions {
  AxisConfig axis;                        ///< configuration
  AxisSwitches switches = {};             ///< cam switches
  AxisCompare compare = {};               ///< position compare
  Follow follow = {};                     ///< live master of the axis
  std::shared_ptr<AxisDrive> drive = {};  ///< drive that receives the setpoints; null: no drive
  Units units{};  ///< units of the axis; tables in other units are rejected; empty: not checked
  ReceiverOptions receiver{};  ///< options of its receiver, with the name of the axis
  bool enable = true;          ///< true: the axis is enabled at the start; false: a command must
                               ///< enable it
  std::optional<StoredTable> table = {};  ///< table over time that the command StartTable plays;
                                          ///< nullopt: none
  /// for a group: its axes; nullopt: the options are for a single axis
  std::optional<ExecutorGroup> group = {};
  /// True: at standstill, arming a table sets the position of the axis to the start of the table.
  bool adopt_start = false;
  bool stop_when_silent = true;  ///< true: stop a motion if its session times out
  /// Tables with more knots than this are prepared in a separate thread, so that a stop need not
  /// wait for the preparation. Default: no table is prepared in a separate thread.
  std::size_t build_apart = std::size_t{1} << 62U;
  Nanos status_period = std::chrono::milliseconds(50);      ///< time between two status messages
  std::optional<std::filesystem::path> log{};               ///< tick log, a CSV file; nullopt: none
  std::function<void(const std::string& notice)> notify{};  ///< receives notices as text
  Recorder* recorder = nullptr;  ///< recorder of the whole machine; null: no record
  Trace* trace = nullptr;        ///< receives the ticks and tables of the axis; null: no trace
};

}  // namespace jounce
