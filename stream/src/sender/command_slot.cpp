// SPDX-License-Identifier: Apache-2.0
#include "jounce/stream/detail/command_slot.hpp"

#include <utility>
#include <variant>

namespace jounce {

void CommandSlot::issue(wire::Body body) {
  ++number_;
  std::visit(
      [&](auto& each) {
        if constexpr (requires { each.command; }) each.command = number_;
      },
      body);
  body_ = std::move(body);
  begun_.reset();
}

std::optional<wire::Body> CommandSlot::due(Nanos now, Nanos repeat) {
  const bool hurried = std::exchange(hurried_, false);
  if (!body_ || (begun_ && now - sent_ < repeat && !hurried)) return std::nullopt;
  if (!begun_) begun_ = now;
  sent_ = now;
  return body_;
}

}  // namespace jounce
