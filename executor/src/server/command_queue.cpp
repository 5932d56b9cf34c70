// SPDX-License-Identifier: Apache-2.0
#include "executor/src/server/command_queue.hpp"

#include <utility>

namespace jounce {

void CommandQueue::send(Command command) {
  command.id = ++numbers_;
  waiting_.push_back(command);
}

void CommandQueue::send(const Command& command, const Request& request) {
  send(command);
  unanswered_[numbers_] = request;
}

std::vector<std::uint64_t> CommandQueue::clear() {
  std::vector<std::uint64_t> dropped;
  std::deque<Command> kept;
  for (const Command& command : waiting_) {
    const CommandKind kind = command.kind();
    const bool again = !kept.empty() && kept.back().kind() == kind;
    if ((kind == CommandKind::abort || kind == CommandKind::disable) && !again) {
      kept.push_back(command);
      continue;
    }
    if (const Movement* const movement = movement_of(command.what))
      dropped.push_back(movement->id());
    unanswered_.erase(command.id);
  }
  waiting_ = std::move(kept);
  return dropped;
}

void CommandQueue::flush() {
  for (; !waiting_.empty() && under_way_ < AxisExchange::most_commands; waiting_.pop_front()) {
    exchange_.commands.push(waiting_.front());
    ++under_way_;
  }
}

std::optional<CommandQueue::Reply> CommandQueue::take_answer() {
  Answer answer;
  if (!exchange_.answers.pop(answer)) return std::nullopt;
  if (answer.id != 0) --under_way_;
  Reply reply{answer};
  if (const auto asked = unanswered_.extract(answer.id)) reply.request = asked.mapped();
  return reply;
}

}  // namespace jounce
