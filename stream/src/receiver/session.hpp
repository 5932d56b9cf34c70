// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <deque>
#include <string>

#include "jounce/command/cause.hpp"
#include "jounce/stream/message/message.hpp"
#include "jounce/stream/transport/transport.hpp"

#include "stream/src/message/refusal.hpp"

namespace jounce {

/// Length of the silence that ends a session.
struct SessionTimeouts {
  Nanos usual{};
  Nanos hold{};  ///< from the first hold-to-run jog until the end of the session
};

/// True if this message can open a session.
bool opens_session(const wire::Body& body);

/// The session of an axis. An axis has at most one session at a time, and a session that has ended
/// cannot open again.
///
///     Session session(timeouts);
///     if (session.is_silent(now)) session.end();
///     if (Refused no = session.bars(message, challenge)) ...          // an answer to its sender
///     if (session.is_free() && opens_session(message.body)) session.open(id, challenge);
///     session.receive(now);                                           // a sign of life
class Session {
 public:
  explicit Session(const SessionTimeouts& timeouts) : timeouts_(timeouts) {}

  [[nodiscard]] bool is_free() const { return id_ == 0; }
  [[nodiscard]] std::int64_t id() const { return id_; }        ///< 0: the axis is free
  [[nodiscard]] std::int64_t owner() const { return owner_; }  ///< the present, or the last one

  /// Returns the reason why this message must have no effect, or none. `challenge` is the present
  /// challenge of the executor.
  [[nodiscard]] Refused bars(const wire::Message& message, std::int64_t challenge) const;
  /// True if the last owner sent this message after the end of its session.
  [[nodiscard]] bool is_of_last_owner(const wire::Message& message) const;

  void open(std::int64_t id, std::int64_t challenge);
  /// Records a message of the owner, at the time `now`.
  void receive(Nanos now) { received_ = now; }
  /// Applies the timeout `hold` from now to the end of the session.
  void hold() { holds_ = true; }
  [[nodiscard]] bool is_silent(Nanos now) const;
  /// Ends the session. `reason`: the answer to its later messages; may be empty. `cause`: `stopped` if
  /// the axis was stopped, too.
  void end(std::string reason = {}, Cause cause = Cause::none);
  /// Adds to the answer to an ended session that its end has stopped the axis.
  void stopped(std::int64_t id);

 private:
  struct Ended {
    std::int64_t id = 0;
    std::string reason = {};
    Cause cause = Cause::none;
  };

  SessionTimeouts timeouts_;
  std::int64_t id_ = 0;
  std::int64_t owner_ = 0;
  std::int64_t challenge_ = 0;  // challenge at the start of the present session
  Nanos received_{};
  bool holds_ = false;
  std::deque<Ended> ended_;  // the last sessions that have ended
};

}  // namespace jounce
