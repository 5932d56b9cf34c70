// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <string>
#include <utility>

#include "jounce/base/detail/interrupt.hpp"

namespace jounce {

/// A line on standard error with the progress of long work: on a terminal only, after the first
/// second, at most ten times a second. The destructor clears it.
class ProgressLine {
 public:
  explicit ProgressLine(std::string what);
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  /// Shows the share of the work that is done, from 0 to 1, and the current step.
  void show(double share, const std::string& now = "");

 private:
  std::string what_;
  std::chrono::steady_clock::time_point begun_;
  std::chrono::steady_clock::time_point shown_;
  bool terminal_;
  bool visible_ = false;
};

/// Long work with a progress line, which Ctrl-C stops:
///
///     WatchedWork work("optimizing");
///     while (work.goes_on(share, step)) ...
class WatchedWork {
 public:
  explicit WatchedWork(std::string what) : progress_(std::move(what)) {}

  /// Shows the progress. Returns false after Ctrl-C.
  bool goes_on(double share, const std::string& now = "") {
    progress_.show(share, now);
    return !interrupt_.asked();
  }
  [[nodiscard]] bool interrupted() const { return interrupt_.asked(); }

 private:
  ProgressLine progress_;
  Interrupt interrupt_;
};

}  // namespace jounce
