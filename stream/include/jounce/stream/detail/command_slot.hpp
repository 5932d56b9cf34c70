// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>

#include "jounce/stream/message/message.hpp"
#include "jounce/stream/transport/transport.hpp"

namespace jounce {

/// The command of a session that still waits for its outcome. The command is sent again until the
/// outcome arrives. Every streamer, client and operator sends its commands through this class.
class CommandSlot {
 public:
  /// `last` is the number of the last command of the session; the next command gets the next
  /// number.
  explicit CommandSlot(std::int32_t last = 0) : number_(last) {}

  /// Numbers a command, and replaces the previous one.
  void issue(wire::Body body);
  /// Removes the command: it has an outcome.
  void clear() { body_.reset(); }
  /// Makes the next due() return the command at once. Call when the command has changed.
  void hurry() { hurried_ = true; }

  /// Returns the command if it must be sent now: once at first, then again after each `repeat`.
  /// nullopt: nothing to send.
  [[nodiscard]] std::optional<wire::Body> due(Nanos now, Nanos repeat);

  /// True if no command waits for an outcome.
  [[nodiscard]] bool empty() const { return !body_; }
  [[nodiscard]] std::int32_t number() const { return number_; }  ///< number of the last command
  /// True if this is a reply to the command.
  [[nodiscard]] bool is_answered_by(const wire::Reply& reply) const {
    return body_.has_value() && reply.command == number_;
  }
  /// True if the command was first sent more than `patience` ago.
  [[nodiscard]] bool is_older(Nanos now, Nanos patience) const {
    return body_.has_value() && begun_ && now - *begun_ > patience;
  }
  /// The command; nullopt: none.
  [[nodiscard]] const std::optional<wire::Body>& body() const { return body_; }

 private:
  std::optional<wire::Body> body_;
  std::int32_t number_;
  std::optional<Nanos> begun_;
  Nanos sent_{};
  bool hurried_ = false;
};

}  // namespace jounce
