// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>

#include "jounce/stream/message/message.hpp"
#include "jounce/stream/transport/transport.hpp"

namespace jounce {

/// The one command of a session without an outcome, repeated until it has one. Every streamer,
/// client and operator sends its commands through this class.
class CommandSlot {
 public:
  /// The first command gets the number after `last`.
  explicit CommandSlot(std::int32_t last = 0) : number_(last) {}

  /// Numbers the command; it replaces the previous one.
  void issue(wire::Body body);
  void clear() { body_.reset(); }
  /// The next due() returns the command at once, because it has changed.
  void hurry() { hurried_ = true; }

  /// The message to send now, repeatedly.
  [[nodiscard]] std::optional<wire::Body> due(Nanos now, Nanos repeat);

  [[nodiscard]] bool empty() const { return !body_; }
  [[nodiscard]] std::int32_t number() const { return number_; }  ///< number of the last command
  [[nodiscard]] bool is_answered_by(const wire::Reply& reply) const {
    return body_.has_value() && reply.command == number_;
  }
  [[nodiscard]] bool is_older(Nanos now, Nanos patience) const {
    return body_.has_value() && begun_ && now - *begun_ > patience;
  }
  [[nodiscard]] const std::optional<wire::Body>& body() const { return body_; }

 private:
  std::optional<wire::Body> body_;
  std::int32_t number_;
  std::optional<Nanos> begun_;
  Nanos sent_{};
  bool hurried_ = false;
};

}  // namespace jounce
