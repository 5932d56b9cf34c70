// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

#include "jounce/stream/message/message.hpp"
#include "jounce/stream/transport/transport.hpp"

namespace jounce {

struct MasterIntakeOptions {
  std::string unit;    ///< unit of the master here
  bool keyed = false;  ///< messages are signed: an old epoch never returns
  /// Without a key: after this silence of a sender, any epoch is accepted again.
  Nanos forget = std::chrono::seconds(1);
};

/// Filter of the messages about one master: accepts those with new content. A value type, without
/// clock and network.
///
///     MasterIntake intake({.unit = "mm"});
///     if (intake.take(message, now)) line.receive(...);
///
/// Within an epoch (Master::clock) both `seq` and `stamp_ns` rise; a later epoch has a greater
/// number. Duplicate, overtaken and repeated messages, and those in another unit, are counted and
/// have no other effect. Of two senders of one name, the later one is accepted and the other
/// rejected: the master never alternates between them.
class MasterIntake {
 public:
  explicit MasterIntake(MasterIntakeOptions options) : options_(std::move(options)) {}

  bool take(const wire::Master& message, Nanos now);

  [[nodiscard]] std::int64_t taken() const { return taken_; }
  [[nodiscard]] std::int64_t refused() const { return refused_; }
  /// The unit of a message that was rejected for it; empty: none was.
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
