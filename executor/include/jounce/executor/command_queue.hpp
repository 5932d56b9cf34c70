// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <vector>

#include "jounce/executor/cycle.hpp"

namespace jounce {

/// The commands in transit to one axis, which takes one a tick, and the requests that wait for its
/// answers.
class CommandQueue {
 public:
  /// Sender of a command.
  struct Request {
    std::int64_t session = 0;
    std::int32_t command = 0;
    CommandKind kind = CommandKind::none;
  };
  /// Answer of the axis, with the request that waits for it, if any.
  struct Reply : Answer {
    std::optional<Request> request = {};
  };

  explicit CommandQueue(AxisExchange& axis) : exchange_(axis) {}

  void send(Command command);
  /// Sends a command whose request waits for the answer.
  void send(const Command& command, const Request& request);
  /// Cancels all commands that have not reached the axis, before a stop; but not those that end
  /// more than a stop does. Returns the movements that will not begin.
  [[nodiscard]] std::vector<std::uint64_t> clear();
  /// Passes on as many commands as the axis can take.
  void flush();
  /// The next answer of the axis.
  [[nodiscard]] std::optional<Reply> take_answer();

  [[nodiscard]] bool idle() const { return waiting_.empty() && under_way_ == 0; }
  /// True if more commands wait than any streamer needs.
  [[nodiscard]] bool full() const { return waiting_.size() >= most_waiting; }
  /// The kind of the last waiting command; none: no command waits.
  [[nodiscard]] CommandKind last() const {
    return waiting_.empty() ? CommandKind::none : waiting_.back().kind();
  }

 private:
  static constexpr std::size_t most_waiting = 64;

  AxisExchange& exchange_;
  std::deque<Command> waiting_;
  std::map<std::uint64_t, Request> unanswered_;  // by the command's id
  std::uint64_t numbers_ = 0;
  std::size_t under_way_ = 0;
};

}  // namespace jounce
