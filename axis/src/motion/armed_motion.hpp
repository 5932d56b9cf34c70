// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "jounce/axis/movement.hpp"
#include "jounce/command/commands.hpp"

namespace jounce {

/// The slot for the armed movement of an axis, with the condition of its start. The slot is empty,
/// armed, or waiting. It waits when the start was accepted, but the movement has not begun.
///
///     ArmedMotion armed;
///     armed.arm(&movement, group);
///     armed.accept(StartAt::tick, 1600, 0, now);
///     if (armed.tick_or(-1) == 1600) play(*std::exchange(armed, {}).movement());
///
/// The slot does not own the movement. Unit m: the unit of the axis's master.
class ArmedMotion {
 public:
  /// Arms a movement in place of the previous one. `group` is the number of its group
  /// (command::Arm); 0: no group.
  void arm(Movement* movement, std::int64_t group) noexcept { *this = {movement, group}; }
  /// Accepts the start of the armed movement. `now` is the present tick. `tick` is used for
  /// StartAt::tick: the tick of the start, `now` or later. `position` is used for
  /// StartAt::master_position: the position of the master, m.
  void accept(StartAt when, std::int64_t tick, double position, std::int64_t now) noexcept {
    waiting_ = true;
    when_ = when;
    tick_ = tick;
    position_ = position;
    accepted_ = now;
  }

  ArmedMotion() = default;

  /// True if a movement is armed.
  [[nodiscard]] explicit operator bool() const noexcept { return movement_ != nullptr; }
  /// The armed movement; null if the slot is empty.
  [[nodiscard]] Movement* movement() const noexcept { return movement_; }
  [[nodiscard]] Movement* operator->() const noexcept { return movement_; }
  [[nodiscard]] Movement& operator*() const noexcept { return *movement_; }
  /// Number of the group of the movement; 0: no group.
  [[nodiscard]] std::int64_t group() const noexcept { return group_; }

  /// True if the start was accepted, but the movement has not begun.
  [[nodiscard]] bool waiting() const noexcept { return waiting_; }
  /// True if the start was accepted in this tick.
  [[nodiscard]] bool accepted_in(std::int64_t tick) const noexcept { return accepted_ == tick; }
  /// Condition of the start.
  [[nodiscard]] StartAt when() const noexcept { return when_; }
  /// Position of the master at which the movement starts, m; for StartAt::master_position.
  [[nodiscard]] double position() const noexcept { return position_; }
  /// True if the armed movement follows a live master. Requires a slot that is not empty.
  [[nodiscard]] bool is_live() const noexcept { return movement_->course() == Course::live; }
  /// Returns the tick of the start for StartAt::tick, and `otherwise` for any other condition.
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
  std::int64_t accepted_ = -1;  // tick in which the start was accepted
};

}  // namespace jounce
