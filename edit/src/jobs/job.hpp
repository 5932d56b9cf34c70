// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

namespace jounce::edit_detail {

/// Work in its own thread, with its progress: the optimizer, a proof, a stream. The destructor stops
/// the work and waits for its end.
class Job {
 public:
  /// Result of the work. An exception of the work becomes `error`.
  struct Outcome {
    bool ok = false;          ///< optimizer: not used; proof: proven; stream: the motion has begun
    std::string text = {};    ///< the outcome, as the verb prints it
    std::string error = {};   ///< "": none
    std::string broken = {};  ///< optimizer: checks that the result breaks
    std::optional<std::string> spec = {};  ///< optimizer: the optimized spec
  };
  struct State {
    bool running = true;
    double done = 0;        ///< share of the work, 0 to 1
    std::string step = {};  ///< name of the present step
    Outcome outcome = {};   ///< complete when the work has ended
  };

  /// Starts the work, which calls report() and is_stopped() of its job. `given`: text of the spec.
  Job(std::string given, std::function<Outcome(Job& job)> work);
  ~Job();
  Job(const Job&) = delete;
  Job& operator=(const Job&) = delete;

  [[nodiscard]] State state() const;
  /// The text with which the job began.
  [[nodiscard]] const std::string& given() const { return given_; }
  /// Ends the work early; does not wait.
  void stop() { stopped_ = true; }

  [[nodiscard]] bool is_stopped() const { return stopped_; }
  /// Sets the progress. Returns false if the work must end.
  bool report(double done, std::string step);

 private:
  const std::string given_;
  mutable std::mutex mutex_;
  State state_;
  std::atomic<bool> stopped_{false};
  std::thread thread_;  // last: it uses the others
};

}  // namespace jounce::edit_detail
