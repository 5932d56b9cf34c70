// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <utility>

#include "jounce/axis/movement.hpp"
#include "jounce/axis/tick.hpp"

#include "axis/src/group/group_state.hpp"
#include "axis/src/motion/armed_motion.hpp"

namespace jounce {

/// The armed movement of an axis, and the groups of the armed movement and of the one that is played.
///
///     StartSlot slot;
///     slot.arm(movement, 42, tick);
///     slot.accept(StartAt::tick, tick + 5, 0, tick);
///     const ArmedMotion begun = slot.take();                     // it begins
///     if (Movement* const left = slot.empty(tick)) hand_back(left);
///
/// Always true: a movement leaves the slot once, either by take(), or by empty(), which breaks its group.
/// The slot does not own the movement.
class StartSlot {
 public:
  /// Arms the movement. Requires an empty slot. `group`: number of its group; 0: no group.
  void arm(Movement& movement, std::int64_t group, std::int64_t tick) noexcept {
    armed_.arm(&movement, group);
    groups_.join(group, tick);
  }
  /// Accepts the start of the armed movement (ArmedMotion::accept).
  void accept(StartAt when, std::int64_t at, double position, std::int64_t tick) noexcept {
    armed_.accept(when, at, position, tick);
  }
  /// The armed movement begins now: returns it. Its group is the group of the motion.
  ArmedMotion take() noexcept {
    const ArmedMotion begun = std::exchange(armed_, {});
    group_ = begun.group();
    return begun;
  }
  /// Drops the armed movement, and breaks its group. Returns the movement; null: the slot was empty.
  Movement* empty(std::int64_t tick) noexcept {
    const ArmedMotion was = std::exchange(armed_, {});
    groups_.break_armed(was.group(), was.waiting(), tick);
    return was.movement();
  }
  /// The motion of the present group ends early.
  void break_motion(std::int64_t tick) noexcept { groups_.break_motion(group_, tick); }
  /// The start of a movement of this group was rejected.
  void reject_start(std::int64_t group, std::int64_t tick) noexcept {
    groups_.break_armed(group, false, tick);
  }

  /// The armed movement, with the condition of its start.
  [[nodiscard]] const ArmedMotion& armed() const noexcept { return armed_; }
  /// The armed movement whose start was accepted; null: none.
  [[nodiscard]] Movement* waiting() const noexcept {
    return armed_.waiting() ? armed_.movement() : nullptr;
  }
  /// Group of the motion that is played.
  [[nodiscard]] std::int64_t group() const noexcept { return group_; }
  /// The groups that were broken (GroupState::broken).
  [[nodiscard]] const std::array<std::int64_t, 2>& broken() const noexcept {
    return groups_.broken();
  }
  /// The armed movement and its start, as the other axes of its group read them.
  [[nodiscard]] GroupStart next() const noexcept {
    if (!armed_ || armed_.group() == 0) return {};
    return {armed_.group(), armed_.waiting(), armed_.tick_or(-1)};
  }

 private:
  ArmedMotion armed_;
  std::int64_t group_ = 0;
  GroupState groups_;
};

}  // namespace jounce
