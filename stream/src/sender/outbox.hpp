// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <optional>
#include <utility>

#include "jounce/stream/transport/link.hpp"

namespace jounce::stream_detail {

/// Sends messages over a link. A failed send counts as a lost packet, which the protocol repeats or
/// tolerates: it must not end a motion.
class Outbox {
 public:
  /// `link` and `clock` must outlive the outbox.
  Outbox(Transport& link, std::optional<wire::Key> key, const Clock& clock)
      : link_(link), key_(std::move(key)), clock_(clock) {}

  /// Throws TransportError if each send has failed for longer than `longest`.
  void send(const wire::Message& message) {
    try {
      send_message(link_, message, key_);
      failed_.reset();
    } catch (const TransportError&) {
      if (!failed_) failed_ = clock_();
      if (clock_() - *failed_ > longest) throw;
    }
  }

 private:
  static constexpr Nanos longest =
      std::chrono::milliseconds(300);  ///< below the timeout of a session

  Transport& link_;
  std::optional<wire::Key> key_;
  const Clock& clock_;
  std::optional<Nanos> failed_;  ///< time of the first failure since the last success
};

}  // namespace jounce::stream_detail
