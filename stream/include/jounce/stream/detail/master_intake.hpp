// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

#include "jounce/stream/message/message.hpp"
#include "jounce/stream/transport/transport.hpp"

namespace jounce {

/// Options of a MasterIntake.
struct MasterIntakeOptions {
  std::string unit = {};  ///< unit of the master in this executor
  /// True: messages are authenticated, so a later message from an earlier epoch (see below) is
  /// never accepted.
  bool keyed = false;
  /// Without a key: after a silence of this length, a message of any epoch is accepted.
  Nanos forget = std::chrono::seconds(1);
};

/// Filters the messages about one master: accepts the messages with new content. A value type,
/// without clock and network.
///
///     MasterIntake intake({.unit = "mm"});
///     if (intake.take(message, now)) line.receive(sample);
///
/// An epoch is a period in which the sender uses one clock (Master::clock); a later epoch has a
/// greater number. Within an epoch, `seq` and `stamp_ns` ascend. Messages that are repeated, late,
/// or in another unit are only counted. If two senders have the same name, the one with the later
/// epoch is accepted and the other one rejected, so the master never alternates between them.
class MasterIntake {
 public:
  explicit MasterIntake(MasterIntakeOptions options) : options_(std::move(options)) {}

  /// Returns true if the message is accepted. `now`: time of its arrival.
  bool take(const wire::Master& message, Nanos now);

  /// Number of accepted messages.
  [[nodiscard]] std::int64_t taken() const { return taken_; }
  /// Number of rejected messages.
  [[nodiscard]] std::int64_t refused() const { return refused_; }
  /// The unit of a message that was rejected for its unit; "": none.
  [[nodiscard]] const std::string& other_unit() const { return other_unit_; }

 private:
  [[nodiscard]] bool is_news(const wire::Master& message, Nanos now) const;

  MasterIntakeOptions options_;
  wire::Master last_;
  Nanos heard_{};  // time of the last accepted message
  std::int64_t taken_ = 0;
  std::int64_t refused_ = 0;
  std::string other_unit_;
};

}  // namespace jounce
