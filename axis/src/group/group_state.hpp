// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

namespace jounce {

/// The groups (machine.hpp) that an axis has broken; 0: none. An axis breaks a group if a stop, a
/// halt, a fault or a rejected start ends its motion or its armed movement early.
///
///     GroupState groups;
///     groups.join(42, tick);                   // a movement of this group is armed
///     groups.break_motion(42, tick);           // a motion of this group ends early
///     if (groups.broken()[0] == 42) ...        // until the axis arms a movement of the group again
class GroupState {
 public:
  /// [0]: group of the motion, [1]: group of the armed movement; 0: not broken.
  [[nodiscard]] const std::array<std::int64_t, 2>& broken() const noexcept { return broken_; }

  /// Records that a motion of this group ended early in this tick.
  void break_motion(std::int64_t group, std::int64_t tick) noexcept {
    broken_[0] = group;
    last_ = {group, tick};
  }
  /// Records that an armed movement of this group was dropped. `waiting`: its start was accepted.
  void break_armed(std::int64_t group, bool waiting, std::int64_t tick) noexcept {
    if (group == 0) return;
    broken_[1] = group;
    if (waiting) last_ = {group, tick};
  }
  /// Removes the group from broken(): the axis arms a movement of the group again. If the group was
  /// broken in the same tick, it stays, because the other axes have not read it yet.
  void join(std::int64_t group, std::int64_t tick) noexcept {
    if (last_.group == group && last_.tick == tick) return;
    std::replace(broken_.begin(), broken_.end(), group, std::int64_t{0});
  }

 private:
  struct Break {
    std::int64_t group = 0;
    std::int64_t tick = -1;
  };

  std::array<std::int64_t, 2> broken_{};
  Break last_;
};

}  // namespace jounce
