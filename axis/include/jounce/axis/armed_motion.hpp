// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "jounce/axis/movement.hpp"
#include "jounce/command/commands.hpp"

namespace jounce {

/// The armed movement of an axis, and its start: empty, armed, or waiting for its start.
///
///     ArmedMotion armed;
///     armed.arm(&movement, group);
///     armed.accept(StartAt::tick, 1600, 0, now);
///     if (armed.tick_or(-1) == 1600) play(*std::exchange(armed, {}).movement());
///
/// It does not own the movement.
class ArmedMotion {
 public:
  /// Replaces an armed movement. `group`: 0: none.
  void arm(Movement* movement, std::int64_t group) noexcept { *this = {movement, group}; }
  /// Accepts the start of the armed movement in the tick `now`. `tick`: for StartAt::tick, `now` or
  /// later. `position`: m, for StartAt::master_position.
  void accept(StartAt when, std::int64_t tick, double position, std::int64_t now) noexcept {
    waiting_ = true;
    when_ = when;
    tick_ = tick;
    position_ = position;
    accepted_ = now;
  }

  ArmedMotion() = default;

  [[nodiscard]] explicit operator bool() const noexcept { return movement_ != nullptr; }
  [[nodiscard]] Movement* movement() const noexcept { return movement_; }
  [[nodiscard]] Movement* operator->() const noexcept { return movement_; }
  [[nodiscard]] Movement& operator*() const noexcept { return *movement_; }
  [[nodiscard]] std::int64_t group() const noexcept { return group_; }

  /// True if its start was accepted and has not begun.
  [[nodiscard]] bool waiting() const noexcept { return waiting_; }
  [[nodiscard]] bool accepted_in(std::int64_t tick) const noexcept { return accepted_ == tick; }
  [[nodiscard]] StartAt when() const noexcept { return when_; }
  [[nodiscard]] double position() const noexcept { return position_; }
  [[nodiscard]] bool is_live() const noexcept { return movement_->course() == Course::live; }
  /// Tick of its start, of a start that begins then; `otherwise` for another event.
  [[nodiscard]] std::int64_t tick_or(std::int64_t otherwise) const noexcept {
    return when_ == StartAt::tick ? tick_ : otherwise;
  }

 private:
  ArmedMotion(Movement* movement, std::int64_t group) : movement_(movement), group_(group) {}

  Movement* movement_ = nullptr;
  std::int64_t group_ = 0;
  bool waiting_ = false;
  StartAt when_ = StartAt::tick;
  std::int64_t tick_ = 0;
  double position_ = 0;         // m
  std::int64_t accepted_ = -1;  // tick
};

}  // namespace jounce
