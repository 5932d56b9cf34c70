// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "jounce/profiles/moves/move.hpp"

namespace jounce::profiles_detail {

/// The range of a profile's position relative to a frame that moves at a constant
/// velocity, from its start, u.
struct Travel {
  double lowest = 0, highest = 0;
  double distance = 0;  ///< at its end
  double path = 0;      ///< length of its path, in both directions
};
Travel travelled(const Profile& profile, double velocity = 0) noexcept;

/// The same for the velocity, u/s.
Travel travelled_in_velocity(const Profile& profile) noexcept;

/// True if a motion reverses on its way, by more than a share of it and rounding: it then passes its
/// end or goes back.
bool turns_round(const Travel& travel, double share, double tolerance) noexcept;

/// True if a profile keeps every bound from its start on, to a share of 1e-12.
bool keeps(const Profile& profile, const Bounds& bounds) noexcept;

}  // namespace jounce::profiles_detail
