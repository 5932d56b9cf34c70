// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "jounce/stream/detail/receiver.hpp"
#include "jounce/stream/detail/row_sender.hpp"
#include "jounce/stream/detail/sender.hpp"
#include "jounce/stream/message/wire.hpp"
#include "jounce/stream/transport/link.hpp"
#include "jounce/stream/transport/transport.hpp"

namespace jounce {

/// Options of stream_tables().
struct StreamOptions {
  SenderOptions sender = {};                    ///< options of the Sender
  Nanos total = std::chrono::seconds(60);       ///< time limit of the whole call
  Nanos period = std::chrono::milliseconds(1);  ///< longest wait for messages
  std::function<void(const StreamProgress&)> progress =
      {};  ///< called in each iteration; may be empty
  /// Returns true to cancel: the armed motion is stopped, and the call ends. May be empty.
  std::function<bool()> cancelled = {};
  std::optional<wire::Key> key{};  ///< key of the executor; nullopt: none
};

/// Runs a Sender to its goal, then releases the session; a motion continues. Returns within
/// options.total, in any state of the link, plus the time of a few last messages that free the axis
/// (farewell.hpp). Throws InputError like Sender, and TransportError. If a function of the options
/// throws, the motion is stopped as if `cancelled` returned true, and the exception is rethrown.
StreamOutcome stream_tables(Transport& link, StreamPlan plan, const StreamOptions& options = {},
                            const Clock& clock = steady_now, std::int64_t session = random_id());

/// Options of stream_rows().
struct RowOptions {
  SenderOptions sender = {};                    ///< options of the RowSender
  Nanos period = std::chrono::milliseconds(1);  ///< longest wait for messages
  std::function<void(const RowProgress&)> progress =
      {};  ///< called in each iteration; may be empty
  /// Returns true to cancel: the axis is stopped, and the call ends. May be empty.
  std::function<bool()> cancelled = {};
  std::optional<wire::Key> key{};  ///< key of the executor; nullopt: none
};

/// Runs a RowSender to the end of the motion, without a time limit. Returns earlier after an error.
/// Throws InputError like RowSender, and TransportError. If the source of the rows or a function of
/// the options throws, the axis is stopped, and the exception is rethrown.
RowOutcome stream_rows(Transport& link, RowPlan plan, const RowOptions& options = {},
                       const Clock& clock = steady_now, std::int64_t session = random_id());

/// Greatest duration of a call of an operator, by default.
inline constexpr Nanos operator_patience = std::chrono::seconds(2);

/// Sends a command of an operator, who needs no session: a Stop, or a Command to hold, resume or
/// override. The function sets the number of the command, and repeats the command until the
/// executor answers, for at most `patience`. Returns the reply; without an answer, its outcome is
/// `pending`.
wire::Reply operator_command(Transport& link, const std::string& executor, wire::Body body,
                             Nanos patience = operator_patience,
                             const std::optional<wire::Key>& key = {},
                             const Clock& clock = steady_now);

/// Stops an axis as an operator, without a session; this ends the session of the axis. The function
/// repeats the stop until the executor answers, for at most `patience`. Returns true if the
/// executor has confirmed the stop.
bool operator_stop(Transport& link, const std::string& executor, wire::StopMode mode,
                   Nanos patience = operator_patience, const std::optional<wire::Key>& key = {},
                   const Clock& clock = steady_now);

/// Returns the present status of an axis: subscribes to its status channel with capacity 1, drops
/// the messages that wait on the link, then waits for the next status, for at most `timeout`.
/// Returns nullopt if none arrives.
std::optional<wire::Message> next_status(Transport& link, const std::string& executor,
                                         Nanos timeout, const std::optional<wire::Key>& key = {},
                                         const Clock& clock = steady_now);

/// The loop of an executor's communication thread: it connects the Receivers, one for each axis, to
/// one link.
///
///     ReceiverPump pump(link, {.executor = "feeder"}, random_id());
///     for (;;) {
///       pump.run(2ms);                                              // receives, answers
///       while (const auto event = pump.receiver().take_event()) ... // to the axis
///       pump.publish(status);                                       // every few milliseconds
///     }
class ReceiverPump {
 public:
  /// Subscribes to the channels of the axes. `link` must outlive the pump. `boot`: number of this
  /// start of the executor.
  ReceiverPump(Transport& link, const std::vector<ReceiverOptions>& options, std::int64_t boot,
               Clock clock = steady_now);
  ReceiverPump(Transport& link, const ReceiverOptions& options, std::int64_t boot,
               Clock clock = steady_now)
      : ReceiverPump(link, std::vector{options}, boot, std::move(clock)) {}

  /// Waits for messages for at most `timeout`, processes all that have arrived, and sends the
  /// answers. If a table becomes complete, the call takes longer, because it computes the hash:
  /// about one second for several hundred megabytes.
  void run(Nanos timeout);
  /// Sends the answers that are ready.
  void answer();
  /// Sends the status of an axis, with the boot number and the counts of rejected packets.
  void publish(wire::Status status, std::size_t axis = 0);
  /// Sends an event of an axis, with the boot number.
  void announce(wire::Event event, std::size_t axis = 0);
  /// Sends the state of a master that an axis follows.
  void publish_master(wire::MasterStatus status, std::size_t axis = 0);
  /// Sends the place of a group on its path, with the boot number.
  void publish_group(wire::GroupStatus status, std::size_t axis = 0);

  /// Subscribes to the samples of the master with this name, and passes each sample to `take`.
  void subscribe(const std::string& master, std::function<void(const wire::Master&)> take);
  /// Subscribes to the claims for the names of the axes, and passes each claim to `take`.
  void subscribe_claims(std::function<void(const wire::Message&)> take);
  /// Sends a message.
  void send(const wire::Message& message) { send_message(link_, message, key_); }

  /// Returns the receiver of an axis.
  [[nodiscard]] Receiver& receiver(std::size_t axis = 0) { return receivers_[axis]; }
  [[nodiscard]] const Receiver& receiver(std::size_t axis = 0) const { return receivers_[axis]; }
  /// Counts of the packets that were rejected.
  [[nodiscard]] const Rejects& rejects() const { return rejects_; }

 private:
  struct Named {
    std::string name = {};
    Receiver* receiver = nullptr;
    std::size_t half_a_window = 0;
    std::size_t unanswered = 0;  // doubles since the last answers
  };

  void take(const wire::Message& message);

  Transport& link_;
  std::optional<wire::Key> key_;    // key of all axes
  std::deque<Receiver> receivers_;  // in the order of the options
  std::vector<Named> by_name_;      // sorted
  std::vector<std::pair<std::string, std::function<void(const wire::Master&)>>> masters_;
  std::function<void(const wire::Message&)> claims_;
  Clock clock_;
  Rejects rejects_;
};

}  // namespace jounce
