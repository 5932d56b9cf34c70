// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "jounce/profiles/curve/curve.hpp"
#include "jounce/profiles/limits/limits.hpp"
#include "jounce/pvt/table.hpp"

namespace jounce {

/// Report features of a table that are possibly not intended, as findings of Severity::warning. No
/// finding is broken. Exact: extrema and one-sided limits, no samples.
///
///     const Trajectory f = table.curve<OverTime>();
///     Report beyond = overshoot(f);       // HMPL's example: segment 1 down to -188.7 mm
///     Report steps = velocity_steps(f);   // places where the velocity steps
///
/// The overloads for a table return the findings of its curve, without making the curve. For a
/// table over a master, "velocity" means geo_velocity. `tolerance` is a share of the travel or of
/// the greatest velocity; a value below it counts as rounding.

/// Returns "warning/overshoot" for each segment that leaves the range between its two knots. value:
/// the extreme position; limit: the position of the knot that is passed; margin: the excess with a
/// negative sign, as a share of the travel. For a cubic or a parabola, the advice gives the end
/// velocities and a sufficient condition against overshoot: both velocities have the direction of
/// the chord, and at most 3 times its slope (Fritsch and Carlson, SIAM J. Numer. Anal. 17, 1980).
/// If the end velocities have opposite directions, so that the segment must reverse, the finding is
/// a note. `unit`: unit of the velocity, for the advice.
template <class Over>
Report overshoot(const Curve<Over>& f, const std::string& unit = "", double tolerance = 1e-9);
Report overshoot(const Table& table, const std::string& unit = "", double tolerance = 1e-9);

/// Reports steps of the velocity; value: right limit minus left limit.
///
/// - "pt/velocity_step": at a break. If the curve holds outside, also from rest to its start.
/// - "pt/end_velocity": the curve ends in motion; value: the velocity. If the curve holds, the axis
///   stops at once at the end. If the curve refuses, the finding is a note, because another motion
///   must follow.
/// - "pt/wrap": from the end of a period to the start of the next.
template <class Over>
Report velocity_steps(const Curve<Over>& f, double tolerance = 1e-9);
Report velocity_steps(const Table& table, double tolerance = 1e-9);

}  // namespace jounce
