// SPDX-License-Identifier: Apache-2.0
#include "stream/src/receiver/last_command.hpp"

#include <type_traits>
#include <utility>

namespace jounce {

std::int32_t command_number(const wire::Body& body) {
  return std::visit(
      [](const auto& each) -> std::int32_t {
        using Each = std::decay_t<decltype(each)>;
        if constexpr (requires { each.command; } && !std::is_same_v<Each, wire::Reply>)
          return each.command;
        else
          return 0;
      },
      body);
}

bool LastCommand::begin(Kind kind, std::int32_t number) {
  if (number < reply_.command) return false;
  if (number > reply_.command) {
    replace(kind, number);
    return true;
  }
  due_ = true;
  return false;
}

void LastCommand::replace(Kind kind, std::int32_t number) {
  kind_ = kind;
  reply_ = {.boot = reply_.boot, .command = number};
  due_ = true;
  what_.reset();
}

void LastCommand::settle(Refused refused) {
  reply_.outcome = refused ? wire::Outcome::refused : wire::Outcome::accepted;
  reply_.refusal = refused.refusal;
  reply_.cause = refused.cause;
  reply_.reason = std::move(refused.reason);
  due_ = true;
}

bool LastCommand::is_news(std::int32_t number) const {
  return reply_.command == 0 || number > reply_.command || waits(number);
}

bool LastCommand::waits(std::int32_t number) const {
  return number != 0 && number == reply_.command && reply_.outcome == wire::Outcome::pending;
}

std::optional<wire::Reply> LastCommand::take_reply() {
  return std::exchange(due_, false) ? std::optional(reply_) : std::nullopt;
}

}  // namespace jounce
