// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "jounce/path/law.hpp"

namespace jounce {

/// Duration T and distance D of a ramp between two velocities, with zero acceleration at both ends.
/// T = 2 sqrt(dv / J) if A is not reached, otherwise dv / A + A / J; D = (v0 + v1) / 2 T.
inline double ramp_time(double dv, double acceleration, double jerk) {
  if (std::isinf(jerk)) return dv / acceleration;
  return dv * jerk > acceleration * acceleration ? dv / acceleration + acceleration / jerk
                                                 : 2 * std::sqrt(dv / jerk);
}
inline double ramp_distance(double v0, double v1, double acceleration, double jerk) {
  return 0.5 * (v0 + v1) * ramp_time(std::abs(v1 - v0), acceleration, jerk);
}

/// Position and its derivatives at t after the start of successive phases.
Motion motion_of(std::span<const LawPhase> phases, double t);

/// Position within a stretch and its derivatives, at t after its start.
Motion motion_in(const LawInterval& stretch, double t);

/// A phase as a segment.
Segment segment_of(const LawPhase& phase);

}  // namespace jounce
