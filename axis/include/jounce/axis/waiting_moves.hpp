// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <variant>

#include "jounce/command/commands.hpp"

namespace jounce {

/// A move that may wait for another one.
using BufferedMove =
    std::variant<command::MoveAbsolute, command::MoveRelative, command::MoveVelocity>;

inline BufferMode buffer_of(const BufferedMove& move) {
  return std::visit([](const auto& each) { return each.buffer; }, move);
}

/// Its target, its distance or its velocity.
inline double value_of(const BufferedMove& move) {
  return std::visit(
      [](const auto& each) {
        if constexpr (requires { each.position; }) return each.position;
        if constexpr (requires { each.distance; }) return each.distance;
        if constexpr (requires { each.velocity; }) return each.velocity;
      },
      move);
}

/// Moves that each wait for the end of the previous one: the motion buffer of an axis (PLCopen part
/// 1, 2.4.2 asks for one place; motion controllers have several). A value of fixed size.
///
///     WaitingMoves moves;
///     if (!moves.full()) moves.push(command::MoveRelative{.distance = 3});
///     const BufferedMove next = moves.front();       // if it is not empty
///     moves.pop();
class WaitingMoves {
 public:
  static constexpr std::size_t most = 8;

  [[nodiscard]] bool empty() const { return size_ == 0; }
  [[nodiscard]] bool full() const { return size_ == most; }
  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] const BufferedMove& front() const { return moves_[0]; }
  [[nodiscard]] const BufferedMove* begin() const { return moves_.data(); }
  [[nodiscard]] const BufferedMove* end() const { return moves_.data() + size_; }

  void push(const BufferedMove& move) { moves_[size_++] = move; }
  void pop() {
    for (std::size_t i = 1; i < size_; ++i) moves_[i - 1] = moves_[i];
    --size_;
  }
  void clear() { size_ = 0; }

 private:
  std::array<BufferedMove, most> moves_{};
  std::size_t size_ = 0;
};

}  // namespace jounce
