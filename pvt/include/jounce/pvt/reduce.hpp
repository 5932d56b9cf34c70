// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>

#include "jounce/profiles/curve/fitted.hpp"
#include "jounce/pvt/sample.hpp"

namespace jounce {

/// Makes tables with the fewest knots. reduced() converts a curve, or a table with too many knots,
/// to a table that a controller can hold.
///
///     Sampled table = reduced(cam, {.rule = Interpolation::cubic_hermite, .tolerance = 1e-3});
///     table.table.size();            // the fewest knots that keep the cam within 1e-3
///     table.error.velocity;          // certified, like table.error.position
///     reduced(cam, {.rule = Interpolation::linear, .most = 17, .x_step = 1});  // best 17 points
///     reduced(old.curve<OverMaster>(), {.tolerance = 1e-3, .p_step = 1});      // in whole counts
///     reduced(composed_within(cam, camshaft, 1e-6), {.tolerance = 1e-3});      // a fitted curve
///
/// **Vocabulary.** A *target* describes the table: its interpolation rule, its permitted deviation
/// from the curve, and the restrictions that the controller has for knots. The *binding*
/// requirement is the one that determines the number of knots.
///
/// **Certified.** The error is the exact maximum of |table - curve| and of |table' - curve'|,
/// including the rounding of the knots. It is computed from extrema of the difference, not from
/// samples.
///
/// **Fewest.** Knots may be anywhere, not only at the breaks of the curve.
/// 1. Each interval is made as long as possible. The result has the fewest knots if the following
///    holds: whenever an interval is within the tolerance, each part of the interval is, too.
/// 2. All intervals are shortened together until they have the same error. For a smooth curve, the
///    error is then within a hundredth of the error of the best table with this number of knots.
///    For other curves it is near the best.
/// 3. For tables of at most 64 knots and curves of at most 128 segments, a further search covers
///    the breaks of the curve and 64 divisions of it: no subset of these places is better by more
///    than a hundredth (pvt/src/sample/best_places.hpp).
///
/// Except for knots at dwells and straight lines, no knot can be removed: two intervals joined in
/// one would break the tolerance.
///
/// **Dwells and straight lines** of the curve (such as a slave in step) are exact intervals of the
/// table, for every tolerance. The two ends of such an interval are knots; on a grid, the knots are
/// the nearest grid places inside the interval. Where several straight lines follow each other,
/// as in a table that was recorded in counts, only dwells of at least 1/64 of the curve are exact.
/// A line is not kept exact if its rounded ends would break the tolerance. Neither dwells nor lines
/// are kept exact if `spacing` leaves no place for their knots.
///
/// **Quadratic pieces.** Each interval between two knots of the curve has an additional knot in its
/// middle, so that the velocity does not step. All other knots are on the curve, so errors do not
/// accumulate. If the curve is quadratic in the interval, one piece is enough.
///
/// **Steps.** A knot has one velocity and one acceleration. If the velocity or acceleration of the
/// curve steps at a knot, the knot gets the left values (beside a dwell: the values of the dwell),
/// and the next interval is as short as necessary.
///
/// **Units** are the units of the curve. **Throws** InputError, with the key and a possible value,
/// for a target that no table satisfies, for a target without any requirement, and for negative
/// numbers.

/// Requirements for the table. At least one of `tolerance`, `velocity_tolerance` and `most` must be
/// given. If only `most` is given, the position error of the table is close to the least that is
/// possible with this number of knots (see Fewest).
struct Target {
  Interpolation rule = Interpolation::cubic_hermite;  ///< interpolation of the table
  /// True: pieces of degree 2, for controllers whose segments have a linear velocity (Googol's
  /// NORMAL). Most intervals need two such pieces. Requires cubic_hermite and no rounding (p_step
  /// and v_step 0).
  bool quadratic = false;
  std::optional<double> tolerance = {};  ///< greatest permitted error of the position, > 0
  /// Greatest permitted error of the first derivative, > 0.
  std::optional<double> velocity_tolerance = {};
  std::optional<std::size_t> most = {};  ///< number of knots that the controller can hold, >= 2
  double spacing = 0;                    ///< least distance between knots
  double x_step = 0;  ///< knots are at whole multiples of this step (1 ms, 1 pulse); 0: at any
                      ///< place
  /// Positions are rounded to whole multiples of this step (counts); 0: not rounded.
  double p_step = 0;
  double v_step = 0;  ///< velocities are rounded to whole multiples of this step; 0: not rounded
};

/// Returns the table with the fewest knots for the target.
///
/// **Rounding.** Positions are rounded, not their increments, so errors do not add up. All
/// increments are whole multiples of the steps, and their sum is the whole travel. The start of the
/// curve must be a whole number of `x_step`. The period of a curve that repeats must be a whole
/// number of `x_step`, and its advance a whole number of `p_step`; otherwise the table would drift,
/// and the function throws. If the curve holds its last value, the table ends at the first multiple of
/// `x_step` at or after the end of the curve. Any other curve must end at such a multiple. The search chooses
/// the farthest possible knot. If the tolerance is below p_step / 2, knots are at places where the
/// curve is close to whole counts.
///
/// A tolerance below the rounding of the curve's numbers (1e-15 of the sum of a segment's terms) is
/// raised to this rounding.
///
/// **Limits.** Between its knots, a table may exceed a limit that the curve satisfies. Intervals
/// that exceed one of the limits are divided, if the target has no steps, is not quadratic, and
/// permits so many knots. Otherwise no knots are added, and check() of the table reports the limit.
template <class Over>
Sampled reduced(const Curve<Over>& f, const Target& target, const Limits& limits = {},
                const RampedLimits& ramped = {});

/// Like reduced() above, for a fitted curve. The error of the fit is subtracted from the tolerances
/// and added to the error of the table. Throws InputError if the error of the fit exceeds a
/// tolerance.
template <class Over>
Sampled reduced(const Fitted<Over>& f, const Target& target);

}  // namespace jounce
