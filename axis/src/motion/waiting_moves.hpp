// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <variant>

#include "jounce/command/commands.hpp"

namespace jounce {

/// A move that may wait in the motion buffer.
using BufferedMove =
    std::variant<command::MoveAbsolute, command::MoveRelative, command::MoveVelocity>;

/// Returns the buffer mode of the move.
inline BufferMode buffer_of(const BufferedMove& move) {
  return std::visit([](const auto& each) { return each.buffer; }, move);
}

/// Returns the target (u), distance (u) or velocity (u/s) of the move; u is the unit of the axis.
inline double value_of(const BufferedMove& move) {
  return std::visit(
      [](const auto& each) {
        if constexpr (requires { each.position; }) return each.position;
        if constexpr (requires { each.distance; }) return each.distance;
        if constexpr (requires { each.velocity; }) return each.velocity;
      },
      move);
}

/// The motion buffer of an axis: moves that each wait for the end of the previous move. (Section
/// 2.4.2 of PLCopen Part 1 requires space for one move; motion controllers have space for several.)
/// The buffer has a fixed size, and copies are independent.
///
///     WaitingMoves moves;
///     if (!moves.full()) moves.push(command::MoveRelative{.distance = 3});
///     const BufferedMove next = moves.front();       // if it is not empty
///     moves.pop();
class WaitingMoves {
 public:
  static constexpr std::size_t most = 8;  ///< greatest number of moves

  [[nodiscard]] bool empty() const { return size_ == 0; }
  [[nodiscard]] bool full() const { return size_ == most; }
  /// Number of moves.
  [[nodiscard]] std::size_t size() const { return size_; }
  /// The move that begins next. Requires a buffer that is not empty.
  [[nodiscard]] const BufferedMove& front() const { return moves_[0]; }
  /// Iterators over the moves, in the order of their execution.
  [[nodiscard]] const BufferedMove* begin() const { return moves_.data(); }
  [[nodiscard]] const BufferedMove* end() const { return moves_.data() + size_; }

  /// Adds a move at the end. Requires a buffer that is not full.
  void push(const BufferedMove& move) { moves_[size_++] = move; }
  /// Removes the first move. Requires a buffer that is not empty.
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
