// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "jounce/profiles/moves/move.hpp"

namespace jounce::profiles_detail {

/// The range of a profile's position relative to a frame that moves at a constant velocity; from
/// the profile's start, u.
struct Travel {
  double lowest = 0, highest = 0;
  double distance = 0;  ///< position at the end
  double path = 0;      ///< length of the path, in both directions
};
Travel travelled(const Profile& profile, double velocity = 0) noexcept;

/// The same for the velocity, u/s.
Travel travelled_in_velocity(const Profile& profile) noexcept;

/// True if a motion reverses by more than a share of its travel and a tolerance: it passes its end,
/// or moves back.
bool turns_round(const Travel& travel, double share, double tolerance) noexcept;

/// True if a profile stays within every bound throughout, with a tolerance of 1e-12 of the bound.
bool keeps(const Profile& profile, const Bounds& bounds) noexcept;

}  // namespace jounce::profiles_detail
