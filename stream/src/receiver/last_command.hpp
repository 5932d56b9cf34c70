// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>

#include "jounce/stream/message/message.hpp"

#include "stream/src/message/refusal.hpp"

namespace jounce {

/// Returns the number of a command; 0: the message is not a command.
std::int32_t command_number(const wire::Body& body);

/// The newest command of a sender, and its outcome. The numbers of the commands ascend, and each
/// command gets one outcome.
///
///     LastCommand last(boot);
///     if (last.begin(LastCommand::Kind::start, start.command)) ...   // else old or repeated
///     last.settle({});                                                 // accepted
///     if (const auto reply = last.take_reply()) ...                    // each due reply once
class LastCommand {
 public:
  enum class Kind { heartbeat, arm, start, stop, command };

  /// `boot`: random number of the executor's start, which each reply carries.
  explicit LastCommand(std::int64_t boot) { reply_.boot = boot; }

  /// Returns true if the command is newer than the recorded one. The command then replaces the
  /// recorded one and waits for its outcome. For a repeated command, the reply becomes due again;
  /// an older command has no effect.
  bool begin(Kind kind, std::int32_t number);
  /// Records the first command of another sender in place of the recorded one. Its number need not
  /// be greater.
  void replace(Kind kind, std::int32_t number);
  /// Forgets the recorded command.
  void clear() { *this = LastCommand(reply_.boot); }

  /// Keeps the command to an axis until its outcome is known.
  void keep(const ClientCommand& what) { what_ = what; }
  void settle(Refused refused);
  /// Makes the reply due again.
  void repeat() { due_ = true; }

  /// True if a command of this number proves that its sender is alive: a new command, or one that
  /// waits for its outcome. The number 0 (a message that is not a command) is a proof only before
  /// the first command; later, such a message may be a repetition by any sender or by the network.
  [[nodiscard]] bool is_news(std::int32_t number) const;
  /// True if the command of this number is the recorded one, and waits for its outcome.
  [[nodiscard]] bool waits(std::int32_t number) const;
  [[nodiscard]] std::int32_t number() const { return reply_.command; }  ///< 0: none
  [[nodiscard]] Kind kind() const { return kind_; }
  [[nodiscard]] const std::optional<ClientCommand>& what() const { return what_; }

  [[nodiscard]] std::optional<wire::Reply> take_reply();

 private:
  Kind kind_ = Kind::heartbeat;
  wire::Reply reply_{};
  bool due_ = false;
  std::optional<ClientCommand> what_{};
};

}  // namespace jounce
