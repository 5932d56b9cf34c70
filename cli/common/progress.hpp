// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <string>

namespace jounce::cli {

/// A line on standard error with the progress of long work: only on a terminal, only after a
/// second, at most ten times a second, gone at the end.
class Progress {
 public:
  explicit Progress(std::string what);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// `share` of the work done, 0 to 1, and what is going on.
  void show(double share, const std::string& now = "");

 private:
  std::string what_;
  std::chrono::steady_clock::time_point begun_;
  std::chrono::steady_clock::time_point shown_;
  bool terminal_;
  bool visible_ = false;
};

}  // namespace jounce::cli
