// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "jounce/stream/message/message.hpp"
#include "jounce/stream/transport/transport.hpp"

namespace jounce {

/// The last messages of a streamer that has failed. They stop the axis, if a motion of the session
/// may be in progress, and end the session, so that the axis is free. Because a message may be
/// lost, all are repeated a few times, until the executor confirms the end of the session.
class Farewell {
 public:
  /// `last`: number of the last command of the session. `stops`: true if the axis must be stopped.
  void begin(std::int32_t last, bool stops);
  /// Returns the messages to send now. `repeat`: time between two repetitions.
  [[nodiscard]] std::vector<wire::Body> due(Nanos now, Nanos repeat);
  /// Processes a reply of the executor.
  void take(const wire::Reply& reply);
  /// True if the executor has confirmed the end of the session, or if all repetitions were sent.
  [[nodiscard]] bool over() const { return left_ == 0; }

 private:
  static constexpr int times = 5;
  std::vector<wire::Body> bodies_;
  std::int32_t release_ = 0;
  std::optional<Nanos> sent_{};
  int left_ = 0;
};

}  // namespace jounce
