// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <cstddef>
#include <mutex>
#include <string>
#include <thread>

#include "jounce/stream/sender/stream_plan.hpp"
#include "jounce/stream/transport/keyed_link.hpp"

namespace jounce::edit_detail {

/// A table that is ready to be sent to an axis, with the facts that a person confirms.
struct StreamOffer {
  std::string text;                ///< text of the spec from which the table was made
  std::string confirmation;        ///< a random number, which permits to send this table once
  LinkOptions link;                ///< address of the executor
  StreamPlan plan;                 ///< the table, its axis and its goal: the start of the motion
  std::string hash;                ///< SHA-256 of the table
  double duration = 0;             ///< duration of the motion, in `time_unit`
  std::string time_unit = {};      ///< unit of `duration`
  double start = 0;                ///< first position of the table, in `position_unit`
  std::string position_unit = {};  ///< unit of `start`
  std::string axis = {};  ///< state and position of the axis; "": the executor did not answer
};

/// Makes the table of an axis (counted from 0) of a spec, or the path of all its axes, for the axis
/// or group `executor`. Asks the executor for its state, and sends nothing else. Throws InputError
/// for a text without a motion, a motion that needs a live master, and a bad name or address.
StreamOffer stream_offer(const std::string& path, const std::string& text, std::size_t axis,
                         const std::string& executor, LinkOptions link);

/// Returns the facts of an offer as the members of a JSON object, without its braces.
std::string members_of(const StreamOffer& offer);

/// Sends a table in its own thread and starts the motion. The destructor cancels a stream that has
/// not started the motion yet.
class StreamJob {
 public:
  explicit StreamJob(StreamOffer offer);
  ~StreamJob();
  StreamJob(const StreamJob&) = delete;
  StreamJob& operator=(const StreamJob&) = delete;

  struct State {
    bool running = true;
    double done = 0;        ///< share of the table that has arrived, 0 to 1
    std::string step = {};  ///< name of the present step
    bool ok = false;        ///< true: the motion has begun
    std::string text = {};  ///< the outcome, as `jounce stream` prints it
  };
  [[nodiscard]] State state() const;
  /// Ends the stream before the motion begins; does not wait.
  void cancel() { cancelled_ = true; }

 private:
  void work();
  [[nodiscard]] State sent();

  const StreamOffer offer_;
  mutable std::mutex mutex_;
  State state_;
  std::atomic<bool> cancelled_{false};
  std::thread thread_;
};

}  // namespace jounce::edit_detail
