// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "jounce/stream/message/message.hpp"
#include "jounce/stream/transport/transport.hpp"

namespace jounce {

/// The last messages of a failed streamer: a stop, if a motion of its session may be in progress,
/// and the end of its session, so that the next streamer finds the axis free. Sends them a few
/// times, since any of them may be lost, until the end of the session is answered.
class Farewell {
 public:
  /// `last`: the number of the session's last command.
  void begin(std::int32_t last, bool stops);
  [[nodiscard]] std::vector<wire::Body> due(Nanos now, Nanos repeat);
  void take(const wire::Reply& reply);
  [[nodiscard]] bool over() const { return left_ == 0; }

 private:
  static constexpr int times = 5;
  std::vector<wire::Body> bodies_;
  std::int32_t release_ = 0;
  std::optional<Nanos> sent_{};
  int left_ = 0;
};

}  // namespace jounce
