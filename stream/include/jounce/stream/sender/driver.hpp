// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "jounce/stream/message/wire.hpp"
#include "jounce/stream/receiver/receiver.hpp"
#include "jounce/stream/sender/row_sender.hpp"
#include "jounce/stream/sender/sender.hpp"
#include "jounce/stream/transport/link.hpp"
#include "jounce/stream/transport/transport.hpp"

namespace jounce {

struct StreamOptions {
  SenderOptions sender;
  Nanos total = std::chrono::seconds(60);               ///< bound on the whole call
  Nanos period = std::chrono::milliseconds(1);          ///< longest wait on the link
  std::function<void(const StreamProgress&)> progress;  ///< called in each iteration; may be empty
  std::function<bool()> cancelled;  ///< true: stops the armed motion and ends; may be empty
  std::optional<wire::Key> key{};   ///< key of the executor; nullopt: none
};

/// Runs a Sender to its goal, then releases the session; a motion continues. Returns within
/// options.total for any state of the link. Throws InputError like Sender, and TransportError.
StreamOutcome stream_tables(Transport& link, StreamPlan plan, const StreamOptions& options = {},
                            const Clock& clock = steady_now, std::int64_t session = random_id());

struct RowOptions {
  SenderOptions sender;
  Nanos period = std::chrono::milliseconds(1);       ///< longest wait on the link
  std::function<void(const RowProgress&)> progress;  ///< called in each iteration; may be empty
  std::function<bool()> cancelled;  ///< true: stops the axis and ends; may be empty
  std::optional<wire::Key> key{};   ///< key of the executor; nullopt: none
};

/// Runs a RowSender to the end of the motion, without a time limit; returns early with an error.
/// Throws InputError like RowSender, TransportError, and, after a stop, the exceptions of the
/// source.
RowOutcome stream_rows(Transport& link, RowPlan plan, const RowOptions& options = {},
                       const Clock& clock = steady_now, std::int64_t session = random_id());

/// An operator's Stop, or Command to hold, resume or override, which need no session; the function
/// draws its number. Repeats it until the executor decides, for at most `patience`: then its
/// outcome is pending.
wire::Reply operator_command(Transport& link, const std::string& executor, wire::Body body,
                             const std::optional<wire::Key>& key,
                             Nanos patience = std::chrono::seconds(2),
                             const Clock& clock = steady_now);

/// An operator's stop: it needs no session and ends the present one. Repeats it until the executor
/// answers, for at most `patience`. Returns true if it was confirmed.
bool operator_stop(Transport& link, const std::string& executor, wire::StopMode mode,
                   Nanos patience = std::chrono::seconds(2), const Clock& clock = steady_now,
                   const std::optional<wire::Key>& key = {});

/// Returns the present status of an axis: drops the waiting status messages, then waits for the
/// next one, for at most `timeout`. The link must have subscribed to the axis's status channel,
/// with capacity 1.
std::optional<wire::Message> next_status(Transport& link, const std::string& executor,
                                         Nanos timeout, const Clock& clock = steady_now,
                                         const std::optional<wire::Key>& key = {});

/// The loop of the communication thread around its Receivers: one for each axis, all on one link.
///
///     ReceiverPump pump(link, {.executor = "feeder"}, random_id());
///     for (;;) {
///       pump.run(2ms);                                              // receives, answers
///       while (const auto event = pump.receiver().take_event()) ... // to the axis
///       pump.publish(status);                                       // every few milliseconds
///     }
class ReceiverPump {
 public:
  /// Subscribes. The link must outlive the pump.
  ReceiverPump(Transport& link, const std::vector<ReceiverOptions>& options, std::int64_t boot,
               Clock clock = steady_now);
  ReceiverPump(Transport& link, const ReceiverOptions& options, std::int64_t boot,
               Clock clock = steady_now)
      : ReceiverPump(link, std::vector{options}, boot, std::move(clock)) {}

  /// Receives the waiting messages, waiting for the first for at most `timeout`, and sends the
  /// answers. A complete table adds the time of its hash: one second for some hundred megabytes.
  void run(Nanos timeout);
  /// Sends the answers that are ready.
  void answer();
  /// Sets boot and the counts of rejected packets, and sends the status.
  void publish(wire::Status status, std::size_t axis = 0);
  /// Sets boot and sends the event.
  void announce(wire::Event event, std::size_t axis = 0);
  void publish_master(wire::MasterStatus status, std::size_t axis = 0);

  /// Subscribes to the samples of the master with this name, and passes each to `take`.
  void hear(const std::string& master, std::function<void(const wire::Master&)> take);
  /// Subscribes to the claims of its axes' names, and passes each of them to `take`.
  void hear_claims(std::function<void(const wire::Message&)> take);
  void send(const wire::Message& message) { send_message(link_, message, key_); }

  [[nodiscard]] Receiver& receiver(std::size_t axis = 0) { return receivers_[axis]; }
  [[nodiscard]] const Receiver& receiver(std::size_t axis = 0) const { return receivers_[axis]; }
  [[nodiscard]] const Rejects& rejects() const { return rejects_; }

 private:
  struct Named {
    std::string name;
    Receiver* receiver;
    std::size_t half_a_window;
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
