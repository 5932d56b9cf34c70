#pragma once

#include <span>
#include <vector>

#include "jounce/profiles/synchronise.hpp"

namespace jounce::detail {

/// The state of every axis at one knot.
using Knot = std::vector<MotionState>;

/// The motion between two neighbouring knots.
struct Hop {
  double duration = 0;  ///< s; infinite where there is none
  std::vector<Profile> profiles;
};

/// All axes from one knot to the next in the least common time, if every axis gets there without
/// turning back on the way.
Hop stretch(std::span<const Bounds> axes, const Knot& from, const Knot& to);

/// The durations between the knots.
std::vector<double> durations(std::span<const Bounds> axes, std::span<const Knot> knots);

/// Chooses velocities and accelerations at the interior knots, which come at rest, so that the
/// motion becomes shorter: a local search over one knot at a time (pattern search; the steps are
/// halved until none helps).
void shorten(std::span<const Bounds> axes, std::span<Knot> knots);

}  // namespace jounce::detail
