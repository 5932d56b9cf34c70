// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "jounce/cam/disc/disc_contour.hpp"

namespace jounce {

/// The motion of a follower on a plate. u is the unit of the slave.
struct PlateMotion {
  std::vector<double> slave = {};  ///< u, lift above the base circle, one for each master position
  /// u, radius of the base circle: the given one or, if the spec gives none, the least distance of
  /// the roller's rim from the cam's center.
  double base_radius = 0;
};

/// Returns the motion of the follower of `spec` on a plate with this profile: the inverse of
/// contour(disc, -roller_radius, ...). The profile is in the frame of the cam at master 0
/// (DiscSpec), in u. If spec.base_radius is 0, the slave is 0 at its least position.
///
///     PlateMotion motion = plate_motion(profile, {.roller_radius = 8, .offset = 3}, masters);
///
/// The roller comes from outside and stops where it touches the profile: the result is the farthest
/// position at which the distance from its center to a line or an arc of the profile equals its
/// radius. This position has a closed form. The roller therefore bridges a hollow that is narrower
/// than itself.
///
/// Throws InputError("profile", ...) for less than two vertices, and if the follower does not meet
/// the plate at one of the masters; and errors of `spec` like Disc.
PlateMotion plate_motion(const Contour& profile, const DiscSpec& spec,
                         std::span<const double> masters);

}  // namespace jounce
