// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "jounce/study/optimum.hpp"

namespace jounce::edit_detail {

/// An optimization in its own thread. The destructor stops it.
class OptimumJob {
 public:
  /// Begins with the text of a spec. `path`: name of the file. Throws InputError for a text that is
  /// not a complete spec.
  OptimumJob(const std::string& path, const std::string& text);
  ~OptimumJob();
  OptimumJob(const OptimumJob&) = delete;
  OptimumJob& operator=(const OptimumJob&) = delete;

  struct State {
    bool running = true;
    double done = 0;         ///< share of the work, 0 to 1
    std::string step = {};   ///< name of the present step
    std::string error = {};  ///< "": none
    std::string text = {};   ///< the outcome, as `jounce optimize` prints it
    /// Checks that the optimum breaks; "": none.
    std::string broken = {};
    /// The optimized spec; nullopt if it breaks a limit.
    std::optional<std::string> spec = {};
  };

  [[nodiscard]] State state() const;
  /// Returns the text with which the job began.
  [[nodiscard]] const std::string& given() const { return given_.document.text; }
  /// Ends the search with the best result so far; does not wait.
  void stop() { stopped_ = true; }

 private:
  void work();

  Spec given_;
  mutable std::mutex mutex_;
  State state_;
  std::atomic<bool> stopped_{false};
  std::thread thread_;
};

}  // namespace jounce::edit_detail
