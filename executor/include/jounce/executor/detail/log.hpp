// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>

#include "jounce/axis/tick.hpp"
#include "jounce/base/hash.hpp"

namespace jounce {

/// Columns of a tick log in addition to those of every log.
struct LogColumns {
  bool master = true;                             ///< position and velocity of the master
  bool path = false;                              ///< time of the path of a group
  bool probes = false;                            ///< captures of the touch probes
  bool profile = false;                           ///< events of cams and follow tables
  std::optional<CorrectionOf> registration = {};  ///< state of the registration
  bool compensation = false;                      ///< state and correction of the compensation
  bool feedback = false;                          ///< actual position and following error
  bool torque = false;                            ///< torque of the drive
};

/// The tick log of an axis: a CSV file with one line for each tick. The first line contains the
/// names and units of the columns. Numbers have the shortest form that reads back exactly.
///
///     TickLog log("run.csv", {.x = "deg", .position = "mm"});
///     log.add(tick);
///     log.close();
///
/// The log is written under a temporary name. close() renames it, so a file with the final name is
/// complete. The destructor removes a log that was not closed. If writing fails (a full disk), the
/// complete lines remain in a file with the ending .truncated, such as run.csv.truncated, and the
/// motion continues.
class TickLog {
 public:
  /// Throws std::system_error if the file cannot be created. `units`: units of the master (x) and
  /// of the position.
  TickLog(std::filesystem::path path, const Units& units, const LogColumns& more = {});
  ~TickLog();
  TickLog(const TickLog&) = delete;
  TickLog& operator=(const TickLog&) = delete;

  /// Adds a line.
  void add(const Tick& tick);
  /// Completes the file and renames it.
  void close();

  /// Reason why the log ended before the end of the run; "" if the log is complete so far.
  [[nodiscard]] const std::string& truncated() const { return truncated_; }

 private:
  void look();
  void keep_whole_lines();

  std::filesystem::path path_;
  std::filesystem::path temporary_;
  std::ofstream file_;
  std::string line_;
  LogColumns more_;
  std::string truncated_;
};

}  // namespace jounce
