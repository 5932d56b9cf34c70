// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "jounce/profiles/curve/segment.hpp"

namespace jounce {

/// Returns the motion of an axis within one cycle of length dt (s), from position x0 (u) and
/// velocity v0 (u/s) to x1 and v1. The result is the cubic with these four values, which is exact
/// if the jerk is constant. If noise or a jump makes the cubic implausible, the result is the
/// straight line from x0 to x1. u is the axis' unit.
///
///     const Segment f = cycle_motion(x0, v0, x1, v1, 1e-3);
///
/// The cubic is plausible in two cases:
/// - It does not reverse: |v| dt <= 3 |x1 - x0| at both ends, and v0 and v1 have the direction of
///   x1 - x0 (sufficient condition of Fritsch and Carlson, 1980).
/// - It reverses once: the mean velocity lies between v0 and v1.
Segment cycle_motion(double x0, double v0, double x1, double v1, double dt);

}  // namespace jounce
