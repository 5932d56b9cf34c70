// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "jounce/executor/detail/cycle.hpp"

namespace jounce {

/// The commands in transit from the communication thread to one axis, and the requests that wait
/// for the answers of the axis. The axis executes one command in each tick.
class CommandQueue {
 public:
  /// The request of a client to which a command belongs.
  struct Request {
    std::int64_t session = 0;              ///< session of the client
    std::int32_t command = 0;              ///< number of the request in its session
    CommandKind kind = CommandKind::none;  ///< kind of the command
    std::string note = {};                 ///< remark for the operator if the axis accepts it
  };
  /// An answer of the axis, with the request that waits for it; nullopt: no request waits.
  struct Reply : Answer {
    std::optional<Request> request = {};  ///< the request that waits
  };

  /// `axis` must outlive the queue.
  explicit CommandQueue(AxisExchange& axis) : exchange_(axis) {}

  /// Sends a command for which no request waits.
  void send(Command command);
  /// Sends a command for which a request waits.
  void send(const Command& command, const Request& request);
  /// Removes all commands that have not reached the axis. Call before you send a stop. An abort and
  /// a disable remain, because they do more than a stop. Returns the ids of the movements that will
  /// not begin.
  [[nodiscard]] std::vector<std::uint64_t> clear();
  /// Passes commands on, as many as the axis can take.
  void flush();
  /// Returns the next answer of the axis; nullopt: none.
  [[nodiscard]] std::optional<Reply> take_answer();

  /// True if no command waits or is in transit.
  [[nodiscard]] bool idle() const { return waiting_.empty() && under_way_ == 0; }
  /// True if so many commands wait that the caller must reject further ones.
  [[nodiscard]] bool full() const { return waiting_.size() >= most_waiting; }
  /// True if a command of this kind waits.
  [[nodiscard]] bool waits(CommandKind kind) const {
    return std::ranges::any_of(waiting_, [&](const Command& one) { return one.kind() == kind; });
  }
  /// Kind of the last waiting command; none if no command waits.
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
