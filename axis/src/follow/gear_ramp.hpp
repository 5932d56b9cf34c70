// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <optional>

#include "jounce/axis/axis_config.hpp"
#include "jounce/axis/movement.hpp"
#include "jounce/gear/gear_in.hpp"

/// The ramp with which a gear engages (LiveGear, LiveCombination).
namespace jounce::axis_detail {

/// Greatest magnitudes of the ramp.
inline Peaks ramp_peaks(const GearInSpec& ramp) {
  return {.acceleration = std::max(ramp.acceleration, ramp.deceleration), .jerk = ramp.jerk};
}

/// The refusal of a ramp that exceeds the limits of the axis.
inline std::optional<Refusal> against_ramp(const GearInSpec& ramp, const AxisConfig& config) {
  const Peaks most = ramp_peaks(ramp);
  const auto& [low, high, v, a, j] = config.limits;
  if (a && most.acceleration > *a) return Refusal{Cause::acceleration_limit, most.acceleration, *a};
  if (j && most.jerk > *j) return Refusal{Cause::jerk_limit, most.jerk, *j};
  return std::nullopt;
}

}  // namespace jounce::axis_detail
