// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "jounce/profiles/online/online_axis.hpp"

namespace jounce {

/// Result of OnlineGenerator::step().
struct OnlineStep {
  /// The reason why an axis cannot move to its goal. It is `not_straight` also while the axes move
  /// off the requested line because no motion on the line stays within the bounds. `not_finite`:
  /// step() was called with an invalid dt.
  MoveStatus status = MoveStatus::ok;
  std::size_t axis = 0;  ///< index of the first axis with this status, if the status is not ok
  bool arrived = false;  ///< true if every enabled axis is at its goal
  /// True if a motion was planned or a goal refused; false if all motions were kept.
  bool planned = false;
};

namespace profiles_detail {

/// The axes of an OnlineGenerator and its memory for planning. All spans have the same size.
struct OnlineGroup {
  std::span<OnlineAxis> axes;
  std::span<AxisMove> moves;
  std::span<Profile> next, rests;
  Sync sync;
  double grid;
  bool regroup;  ///< true: plan all axes, even those whose motion still fits
  /// True: the motion is planned with Sync::time, because no motion on the line stays within the
  /// bounds.
  bool bent = false;

  OnlineStep step(double dt) noexcept;

 private:
  void plan() noexcept;
  [[nodiscard]] bool in_phase() const noexcept;
  [[nodiscard]] bool is_on_its_way() const noexcept;
  bool gather(bool widened) noexcept;
  Synchronized solve() noexcept;
  Synchronized bend(const Synchronized& straight) noexcept;
  [[nodiscard]] bool can_widen() const noexcept;
  [[nodiscard]] bool detour(Judged judged) const noexcept;
  void wait_rather_than_turn_round() noexcept;
  void refuse(const Synchronized& why) noexcept;
  void go() noexcept;
  void gather_halting(bool widened) noexcept;
  void stop() noexcept;
};

}  // namespace profiles_detail
}  // namespace jounce
