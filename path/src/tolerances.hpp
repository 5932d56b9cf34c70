// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace jounce::path_detail {

/// Square of the change of a unit vector that is rounding: both have the same direction.
inline constexpr double same_direction = 1e-28;
/// Share by which entry_velocity() is rounded down, so that the ramp fits: it is accurate to half of it.
inline constexpr double entry_rounding = 2e-14;
/// Least velocity, acceleration and jerk of a plan, u/s, u/s^2, u/s^3: its times stay finite.
inline constexpr double least_rate = 1e-12;
/// Share of the duration of a plan: the rest of a law that has no other stretch.
inline constexpr double shortest_rest = 1e-9;

/// Share of the largest coordinate by which joints may differ from those of the tool position that was
/// computed from them.
inline constexpr double same_joint = 1e-9;

}  // namespace jounce::path_detail
