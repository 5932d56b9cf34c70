// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "jounce/stream/detail/receiver.hpp"
#include "jounce/stream/transport/link.hpp"

namespace jounce {

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
