// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>

#include "jounce/axis/axis.hpp"
#include "jounce/base/hash.hpp"

namespace jounce {

/// The log of an axis: one line of CSV a tick, doubles in the shortest form that reads back
/// identically. The first line names the columns with their units; there are no other lines.
///
///     TickLog log("run.csv", {.x = "deg", .position = "mm"});
///     log.add(tick);
///     log.close();
///
/// The log is written under a temporary name, and close() renames it, so that a file of the final
/// name is complete. A log that was never closed is removed. Throws std::system_error if the file
/// cannot be created. If writing fails later (a full disk), all complete lines remain as
/// run.csv.truncated: motion does not depend on a disk.
class TickLog {
 public:
  TickLog(std::filesystem::path path, const Units& units);
  ~TickLog();
  TickLog(const TickLog&) = delete;
  TickLog& operator=(const TickLog&) = delete;

  void add(const Tick& tick);
  void close();

  /// Reason why the log ended before the run; empty: it did not.
  [[nodiscard]] const std::string& truncated() const { return truncated_; }

 private:
  void look();
  void keep_whole_lines();

  std::filesystem::path path_;
  std::filesystem::path temporary_;
  std::ofstream file_;
  std::string line_;
  std::string truncated_;
};

}  // namespace jounce
