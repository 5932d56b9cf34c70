// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "jounce/profiles/curve/curve.hpp"
#include "jounce/profiles/limits/limits.hpp"
#include "jounce/pvt/table.hpp"

namespace jounce {

/// Possibly unintended features of a table, as findings of Severity::warning;
/// none is ever broken. Exact: extrema and one-sided limits, no samples.
///
///     const Trajectory f = table.curve<OverTime>();
///     Report beyond = overshoot(f);       // HMPL's example: segment 1 down to -188.7 mm
///     Report steps = velocity_steps(f);   // places of infinite acceleration
///
/// For a table: the same as for its curve, without making it.
///
/// Over a master read geo_velocity for velocity. A value below `tolerance` (of the travel or of the
/// greatest velocity) is rounding.

/// "warning/overshoot" for each segment that leaves the range of its two knots' positions. value:
/// the position reached, limit: the knot's position passed, margin: minus the excess as a share of
/// the travel. The advice for a cubic or a parabola names its end velocities and a sufficient
/// condition for no overshoot: both in the direction of the chord and at most 3 times its slope
/// (Fritsch and Carlson, SIAM J. Numer. Anal. 17, 1980). Only a note if the velocities at its ends
/// are opposed: it has to reverse between them.
template <class Over>
Report overshoot(const Curve<Over>& f, double tolerance = 1e-9);
Report overshoot(const Table& table, double tolerance = 1e-9);

/// Steps of the velocity; value: right limit minus left limit.
///
/// - "pt/velocity_step" at a break; if the curve holds outside, also from rest at its start.
/// - "pt/end_velocity": the curve ends moving; value: the velocity. If it holds, the axis stops
///   there at once; if it refuses, only a note: another motion has to take over.
/// - "pt/wrap": from the end of a period to the start of the next.
template <class Over>
Report velocity_steps(const Curve<Over>& f, double tolerance = 1e-9);
Report velocity_steps(const Table& table, double tolerance = 1e-9);

}  // namespace jounce
