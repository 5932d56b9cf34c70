// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "jounce/axis/machine.hpp"
#include "jounce/executor/cycle.hpp"
#include "jounce/stream/receiver/receiver.hpp"

namespace jounce {

class Recorder;

/// Options of one axis of an executor.
struct ExecutorOptions {
  AxisConfig axis;
  AxisSwitches switches = {};
  AxisCompare compare = {};
  Follow follow = {};                     ///< its live master
  std::shared_ptr<AxisDrive> drive = {};  ///< receives the setpoints; null: no drive
  Units units{};               ///< units of the axis: a table in others is rejected; empty: any
  ReceiverOptions receiver{};  ///< includes the name of the axis
  bool enable = true;          ///< at the start; otherwise a command enables it
  std::optional<StoredTable> table = {};  ///< over time; played by the command `start`
  bool adopt_start =
      false;  ///< at standstill, the start of an armed table defines the position of the axis
  bool stop_when_silent = true;  ///< stops a motion whose session times out
  /// Tables of more knots become jobs in a separate thread: a stop does not wait for them.
  std::size_t build_apart = std::size_t{1} << 62U;
  Nanos status_period = std::chrono::milliseconds(50);
  std::optional<std::filesystem::path> log{};               ///< CSV of all ticks
  std::function<void(const std::string& notice)> notify{};  ///< events as text
  Recorder* recorder = nullptr;  ///< recorder of the whole machine; null: no record
};

}  // namespace jounce
