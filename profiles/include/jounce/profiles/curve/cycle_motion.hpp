// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "jounce/profiles/curve/segment.hpp"

namespace jounce {

/// Motion of an axis within a cycle of dt s between its two known ends, as a segment of that
/// length: on the cubic through both positions and velocities (exact for a constant jerk), or on a
/// straight line if the cubic is not in order (noise, a jump).
///
///     const Segment f = cycle_motion(x0, v0, x1, v1, 1e-3);
///
/// In order means: without reversal, monotone by the condition of Fritsch and Carlson (1980) that
/// |v| dt <= 3 |d| at both ends; or with one reversal, for which the mean velocity lies between
/// those at the ends.
Segment cycle_motion(double x0, double v0, double x1, double v1, double dt);

}  // namespace jounce
