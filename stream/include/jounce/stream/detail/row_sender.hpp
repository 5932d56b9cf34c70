// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "jounce/stream/detail/command_slot.hpp"
#include "jounce/stream/detail/farewell.hpp"
#include "jounce/stream/detail/row_window.hpp"
#include "jounce/stream/sender/row_plan.hpp"
#include "jounce/stream/sender/stream_outcome.hpp"

namespace jounce {

/// The streamer's half of a rolling stream, as a pure state machine without thread, clock or link.
/// It opens the queue, sends the prefill (or all rows, if the stream has fewer), arms, and starts.
/// As played rows free space, it sends more rows, up to the end of the motion.
///
///     RowSender sender({.executor = "feeder", .queue = fifo, .rows = next_rows}, random_id());
///     while (!sender.ended()) {
///       for (const auto& message : sender.poll(now)) ...   // send each one; call poll() every ms
///       sender.receive(message, now);                      // each arrived message
///     }
///
/// If the source is too slow, the axis stops on its path, within its limits, before its rows run
/// out: an underrun. The stream then ends with the error `underrun`, or continues if the plan
/// resumes. If rows are needed and the source returns none for `progress_patience`, the stream ends
/// as well: with `underrun` after the start, with `stalled` before the start. If an operator or a
/// fault stops the axis, every stream ends with `stopped`.
class RowSender {
 public:
  /// `session` > 0: a random number. Throws InputError for a plan that cannot be sent.
  RowSender(RowPlan plan, std::int64_t session, SenderOptions options = {});

  /// Returns the messages to send now.
  [[nodiscard]] std::vector<wire::Message> poll(Nanos now);
  /// Processes a message that has arrived.
  void receive(const wire::Message& message, Nanos now);

  /// Stops the axis, and ends.
  void stop(wire::StopMode mode);
  /// Ends with this error.
  void fail(StreamError error, std::string reason);

  /// True if the stream has ended.
  [[nodiscard]] bool ended() const { return stage_ == Stage::ended; }
  /// True if the stream has ended and, after an error, its farewell was sent (farewell.hpp).
  [[nodiscard]] bool done() const { return ended() && farewell_.over(); }
  /// The outcome so far.
  [[nodiscard]] const RowOutcome& outcome() const { return outcome_; }

 private:
  enum class Stage {
    opening,
    filling,
    arming,
    starting,
    playing,
    resetting,
    resuming,
    stopping,
    releasing,
    ended
  };

  void take(const wire::QueueAck& ack, std::int64_t challenge, Nanos now);
  void take(const wire::Reply& reply, std::int64_t challenge, Nanos now);
  template <class Other>
  void take(const Other& /*not for a streamer*/, std::int64_t /*challenge*/, Nanos /*now*/) {}

  [[nodiscard]] bool accept(std::int64_t boot, Nanos now);
  void fill(Nanos now);
  void go_on();
  void watch(const wire::QueueAck& ack);
  void enter(Stage stage, wire::Body command);
  void accepted();
  void refused(wire::Refusal refusal, const std::string& reason, std::int32_t cause);
  [[nodiscard]] bool may_move() const;
  void check_patience(Nanos now);
  void send(wire::Body body, Nanos now);
  [[nodiscard]] bool is_filled() const;
  [[nodiscard]] bool waits_for_rows() const;

  RowPlan plan_;
  std::int64_t session_;
  SenderOptions options_;
  RowOutcome outcome_;
  Stage stage_ = Stage::opening;
  RowWindow window_;
  CommandSlot command_;
  std::int64_t challenge_ = 0;
  std::int64_t boot_ = 0;   // 0: no message yet
  bool exhausted_ = false;  // the source has returned its last row
  bool starving_ = false;
  std::uint64_t starved_at_ = 0;  // acknowledged rows at the underrun
  std::vector<wire::Message> outgoing_;
  bool begun_ = false;
  Farewell farewell_;
  Nanos heard_{}, asked_{}, progressed_{};
};

}  // namespace jounce
