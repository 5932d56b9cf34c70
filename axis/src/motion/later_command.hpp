// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>

#include "jounce/axis/command.hpp"
#include "jounce/command/cause.hpp"

namespace jounce {

/// The command that waits for its own tick (Command::at). At most one command waits, and a command
/// that waits has no movement. The axis checks the conditions of the command in its tick.
///
///     LaterCommand later;
///     if (const auto no = later.postpone(command, tick)) return no;     // rejected
///     if (const auto due = later.take_due(tick)) obey(*due);            // once a tick
///     if (const auto dropped = later.forget()) report(*dropped);        // another motion took over
class LaterCommand {
 public:
  /// Keeps the command for its tick. Returns nullopt, or the reason to reject the command. `tick`: the
  /// present tick.
  std::optional<Refusal> postpone(const Command& command, std::int64_t tick) noexcept {
    const auto at = static_cast<double>(command.at);
    if (command.at < tick) return Refusal{Cause::too_late, at, static_cast<double>(tick)};
    if (command_) return Refusal{Cause::buffer_full, at, static_cast<double>(command_->at)};
    if (movement_of(command.what) != nullptr) return Refusal{Cause::no_value};
    command_ = command;
    return std::nullopt;
  }
  /// Returns the command in its tick, or in the first tick after it, and removes it. The command no
  /// longer has a tick.
  std::optional<Command> take_due(std::int64_t tick) noexcept {
    if (!command_ || command_->at > tick) return std::nullopt;
    std::optional<Command> due = command_;
    command_.reset();
    due->at = -1;
    return due;
  }
  /// Removes the command. Returns the reason for its sender; nullopt: no command waits.
  std::optional<Refusal> forget() noexcept {
    if (!command_) return std::nullopt;
    const Refusal why{Cause::replaced, static_cast<double>(command_->at), 0};
    command_.reset();
    return why;
  }

  /// True if a command waits.
  [[nodiscard]] bool waits() const noexcept { return command_.has_value(); }
  /// Tick of the command that waits; -1: none waits.
  [[nodiscard]] std::int64_t tick() const noexcept { return command_ ? command_->at : -1; }

 private:
  std::optional<Command> command_;
};

}  // namespace jounce
