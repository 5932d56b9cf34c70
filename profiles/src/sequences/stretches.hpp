// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "jounce/profiles/sequences/synchronize.hpp"

namespace jounce::profiles_detail {

/// The state of every axis at one knot.
using Knot = std::vector<MotionState>;

/// The motion between two neighboring knots.
struct Hop {
  double duration = 0;  ///< s; infinite if there is no motion
  std::vector<Profile> profiles;
};

/// The bounds of each axis, for each stretch between two knots.
using StretchBounds = std::vector<std::vector<Bounds>>;

/// The motion of all axes from one knot to the next in the least common time, if every axis can do
/// so without reversing.
Hop stretch(std::span<const Bounds> axes, const Knot& from, const Knot& to);

/// The durations between the knots.
std::vector<double> durations(const StretchBounds& bounds, std::span<const Knot> knots);

/// Shortens the motion by choosing velocities and accelerations at the interior knots. There must
/// be a motion between all neighbors. A local search (pattern search over one knot at a time, whose
/// steps are halved until none helps).
void shorten(const StretchBounds& bounds, std::span<Knot> knots);

}  // namespace jounce::profiles_detail
