// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "jounce/profiles/online/online_axis.hpp"

namespace jounce {

/// Result of a step.
struct OnlineStep {
  /// Why an axis cannot go to its goal; `not_straight` even while the axes are off the line,
  /// because none on it keeps the bounds.
  MoveStatus status = MoveStatus::ok;
  std::size_t axis = 0;  ///< the first such axis, if the status is not ok
  bool arrived = false;  ///< every enabled axis is at its goal
  bool planned = false;  ///< a motion was planned; otherwise all were kept
};

namespace profiles_detail {

/// The axes of an OnlineGenerator and the memory for planning, all of one size.
struct OnlineGroup {
  std::span<OnlineAxis> axes;
  std::span<AxisMove> moves;
  std::span<Profile> next, rests;
  Sync sync;
  double grid;
  bool regroup;       ///< plan all, whether stale or not
  bool bent = false;  ///< planned in time, because no motion on the line keeps the bounds

  OnlineStep step(double dt) noexcept;

 private:
  void plan() noexcept;
  [[nodiscard]] bool in_phase() const noexcept;
  [[nodiscard]] bool is_on_its_way() const noexcept;
  bool gather(bool widened) noexcept;
  Synchronised solve() noexcept;
  Synchronised bend(const Synchronised& straight) noexcept;
  [[nodiscard]] bool can_widen() const noexcept;
  [[nodiscard]] bool detour(Judged judged) const noexcept;
  void wait_rather_than_turn_round() noexcept;
  void refuse(const Synchronised& why) noexcept;
  void go() noexcept;
  void gather_halting(bool widened) noexcept;
  void stop() noexcept;
};

}  // namespace profiles_detail
}  // namespace jounce
