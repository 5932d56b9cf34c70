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
  start,   ///< start of the path
  end,     ///< end of the path
  stop,    ///< a stop at a corner
  corner,  ///< a rounded corner
  curve,   ///< the curvature of an arc or another curve
  limit,   ///< a command with a lower feed, or a direction in which an axis is slow
  dwell,   ///< a dwell
};
constexpr std::size_t loss_causes = 7;  ///< number of causes
const char* name(LossCause cause);      ///< the cause as a word

/// A place where a plan is slower than full speed, and the time that this costs. u is the unit of
/// length of the program, q the path parameter.
struct SpeedLoss {
  LossCause cause = LossCause::start;
  std::int32_t line = 0;                   ///< source line
  double where = 0;                        ///< q of the least speed
  double time = 0;                         ///< s, time of the least speed
  double velocity = 0;                     ///< u/s, least speed
  double loss = 0;                         ///< s, lost time
  std::optional<std::size_t> corner = {};  ///< index of the corner in Plan::corners()
};

/// The duration of a plan as a sum: at_full_speed plus the losses.
///
/// **Full speed** of a piece is the least of its feed, the path's limit of velocity, and the speed
/// at which one of its axes reaches its limit of velocity. **A loss** belongs to a local minimum of
/// the speed. It extends from the local maximum before the minimum to the local maximum after it.
struct PathCost {
  double at_full_speed = 0;            ///< s, duration at full speed
  std::vector<SpeedLoss> losses = {};  ///< in the order of the path

  /// Returns the sum of the losses with this cause, s.
  [[nodiscard]] double of(LossCause cause) const;
};

/// Returns the sum for a plan. `corners`: the result of plan.corners().
PathCost cost_of(const Plan& plan, std::span<const CornerRecord> corners);

}  // namespace jounce
