// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>

#include "jounce/axis/axis.hpp"
#include "jounce/base/hash.hpp"

namespace jounce {

/// The log of an axis: one line of CSV a tick, doubles in shortest form that reads back as the
/// same. The first line names the columns with their units; there is nothing else in the file.
///
///     TickLog log("run.csv", {.x = "deg", .position = "mm"});
///     log.add(tick);
///     log.close();
///
/// It is written under another name beside it and renamed by close(), so that a file of the right
/// name is whole. A log that was never closed is removed. Throws std::system_error where the file
/// cannot be begun. Where it cannot go on (a full disk), what is there up to the last whole line
/// is kept as run.csv.truncated: motion does not depend on a disk.
class TickLog {
 public:
  TickLog(std::filesystem::path path, const Units& units);
  ~TickLog();
  TickLog(const TickLog&) = delete;
  TickLog& operator=(const TickLog&) = delete;

  void add(const Tick& tick);
  void close();

  /// Why the log ended before the run did; empty if it did not.
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
