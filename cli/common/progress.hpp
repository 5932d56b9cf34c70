// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <string>

namespace jounce::cli {

/// A line on standard error with the progress of long work: on a terminal only, after the first second, at most ten
/// times a second. The destructor clears it.
class Progress {
 public:
  explicit Progress(std::string what);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// Shows the share of the work that is done, from 0 to 1, and the current step.
  void show(double share, const std::string& now = "");

 private:
  std::string what_;
  std::chrono::steady_clock::time_point begun_;
  std::chrono::steady_clock::time_point shown_;
  bool terminal_;
  bool visible_ = false;
};

}  // namespace jounce::cli
