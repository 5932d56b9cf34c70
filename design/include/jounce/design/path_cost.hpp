// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "jounce/path/plan.hpp"

namespace jounce {

/// Cause of a local minimum of the speed along a path.
enum class LossCause : std::uint8_t {
  start,
  end,
  stop,    ///< a rest at a corner
  corner,  ///< a rounded corner
  curve,   ///< an arc or another curve, by its curvature
  limit,   ///< a slower command, or a direction in which an axis is slow
  dwell,
};
constexpr std::size_t loss_causes = 7;
const char* name(LossCause cause);

/// Time that a plan loses at one place against full speed.
struct SpeedLoss {
  LossCause cause = LossCause::start;
  std::int32_t line = 0;                   ///< line of the source
  double where = 0;                        ///< q of the least speed
  double time = 0;                         ///< s, when
  double velocity = 0;                     ///< the least speed
  double loss = 0;                         ///< s
  std::optional<std::size_t> corner = {};  ///< index into the corners
};

/// Duration of a plan as a sum: duration = at_full_speed + the losses.
///
/// **Full speed** of a piece is the least of its feed, the path's limit of velocity, and the speed at which one of its
/// axes reaches its limit of velocity. **A loss** belongs to a local minimum of the speed: it counts from the
/// fastest place before it to the fastest place behind it.
struct PathCost {
  double at_full_speed = 0;       ///< s
  std::vector<SpeedLoss> losses;  ///< along the path

  /// Sum of the losses with this cause, s.
  [[nodiscard]] double of(LossCause cause) const;
};

/// `corners`: those of the plan.
PathCost cost_of(const Plan& plan, std::span<const CornerRecord> corners);

}  // namespace jounce
