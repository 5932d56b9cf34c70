// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "jounce/stream/detail/chunk_window.hpp"
#include "jounce/stream/detail/command_slot.hpp"
#include "jounce/stream/detail/farewell.hpp"
#include "jounce/stream/message/message.hpp"
#include "jounce/stream/sender/stream_outcome.hpp"
#include "jounce/stream/sender/stream_plan.hpp"
#include "jounce/stream/transport/transport.hpp"

namespace jounce {

/// The streamer's half of the protocol for tables, as a pure state machine without thread, clock or
/// link.
///
///     Sender sender({.executor = "feeder", .tables = {{table, units}}}, random_id());
///     while (!sender.ended()) {
///       for (const auto& message : sender.poll(now)) ...   // send each one; call poll() every ms
///       sender.receive(message, now);                      // each arrived message
///       sender.hash();                                     // if none has arrived
///       if (sender.at_goal()) sender.release();            // or hold the session, or stop()
///     }
///
/// After a failure, the sender still has to send messages that free the axis (farewell.hpp). So
/// call poll() at least once more, or better until done() is true.
class Sender {
 public:
  /// `session` > 0: a random number. Throws InputError for a plan that cannot be sent or armed.
  Sender(StreamPlan plan, std::int64_t session, SenderOptions options = {});

  /// Returns the messages to send now.
  [[nodiscard]] std::vector<wire::Message> poll(Nanos now);
  /// Processes a message that has arrived.
  void receive(const wire::Message& message, Nanos now);
  /// Hashes one chunk of the present table, if the plan has no hash for it. Call while no message
  /// arrives; otherwise the whole hash is computed when all chunks have arrived. Returns false if
  /// no table needs a hash.
  bool hash();

  /// Changes the goal to a later step.
  void raise(StreamGoal goal);
  /// Changes the goal to a start in this tick of the executor.
  void start_at(std::int64_t tick);
  /// Stops the axis if any motion was armed, and abandons the goal.
  void stop(wire::StopMode mode);
  /// Ends the session; a motion continues.
  void release();
  /// Ends with this error.
  void fail(StreamError error, std::string reason);

  /// True if the goal is reached and the session is kept alive.
  [[nodiscard]] bool at_goal() const { return stage() == StreamStage::holding; }
  /// True if the stream has ended and, after a failure, its last messages were sent.
  [[nodiscard]] bool done() const { return ended() && farewell_.over(); }
  /// True if the stream has ended.
  [[nodiscard]] bool ended() const {
    return stage() == StreamStage::released || stage() == StreamStage::failed;
  }
  /// The outcome so far.
  [[nodiscard]] const StreamOutcome& outcome() const { return outcome_; }
  /// Number of the session.
  [[nodiscard]] std::int64_t session() const { return session_; }
  /// The last challenge of the executor.
  [[nodiscard]] std::int64_t challenge() const { return challenge_; }

 private:
  [[nodiscard]] StreamStage stage() const { return outcome_.progress.stage; }
  void enter(StreamStage stage) { outcome_.progress.stage = stage; }

  void announce_all();
  void download(Nanos now);
  void command(Nanos now);
  void check_patience(Nanos now);
  void send(wire::Body body, Nanos now);
  void take(const wire::Ack& ack, std::int64_t challenge, Nanos now);
  void take(const wire::Reply& reply, std::int64_t challenge, Nanos now);
  void take(const wire::Status& status, std::int64_t challenge, Nanos now);
  template <class Other>
  void take(const Other& /*not for a streamer*/, std::int64_t /*challenge*/, Nanos /*now*/) {}
  bool asks_by_name(Nanos now);
  void begin_anew(std::int64_t challenge);
  [[nodiscard]] bool accept(std::int64_t boot, Nanos now);
  void accepted();
  void refused(wire::Refusal refusal, const std::string& reason, std::int32_t cause = 0);
  void next_table(Nanos now);
  void await_start(const wire::Status& status);
  void be_over(const wire::Status& status);
  [[nodiscard]] wire::Arm arm_of(const SwapPlan& leg) const;
  void pursue();
  void count();

  StreamPlan plan_;
  std::vector<SwapPlan> legs_;
  std::size_t leg_ = 0;  // the next leg to arm or start
  bool leg_armed_ = false;
  std::int32_t start_ = 0;     // number of the last accepted start
  std::optional<Nanos> due_;   // time since which the last start appears to have taken place
  bool waited_ = false;        // true if a status has shown the start as waiting
  std::optional<Nanos> over_;  // time since which the axis is at rest and no start waits
  std::int64_t session_;
  SenderOptions options_;
  std::int64_t challenge_ = 0;  // the last challenge of the executor
  StreamOutcome outcome_;
  std::vector<wire::Header> headers_;
  bool given_up_ = false;  // the goal was abandoned, after a stop
  std::vector<wire::Message> outgoing_;

  std::size_t table_ = 0;              // the present table
  std::optional<ChunkWindow> window_;  // set when the header of the table is acknowledged
  std::size_t arrived_before_ = 0, resent_before_ = 0;
  struct Hashing {
    std::size_t table = 0;
    std::size_t knots = 0;  // knots hashed so far
    ContentHasher hasher{};
  };
  std::optional<Hashing> hashing_;
  bool told_ = false;  // true if the last header contained the hash

  CommandSlot command_;

  std::vector<std::int64_t> boots_;  // boots of the executor, the present one last
  bool begun_ = false;
  Farewell farewell_;
  Nanos heard_{}, progressed_{}, sent_{};
  std::optional<Nanos> header_sent_;
  /// time since which the sender asks, by its hash, for a table for which the executor had no space
  std::optional<Nanos> named_;
};

}  // namespace jounce
