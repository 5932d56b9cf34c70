// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>

#include "jounce/profiles/curve/fitted.hpp"
#include "jounce/pvt/sample.hpp"

namespace jounce {

/// Makes tables with the fewest knots: it reduces a curve, or a table with too many knots, to what
/// a controller can hold.
///
///     Sampled table = reduced(cam, {.rule = Interpolation::cubic_hermite, .tolerance = 1e-3});
///     table.table.size();            // the fewest knots that keep the cam within 1e-3
///     table.error.velocity;          // certified, like table.error.position
///     reduced(cam, {.rule = Interpolation::linear, .most = 17, .x_step = 1});  // best 17 points
///     reduced(old.curve<OverMaster>(), {.tolerance = 1e-3, .p_step = 1});      // in whole counts
///     reduced(composed_within(cam, camshaft, 1e-6), {.tolerance = 1e-3});      // a fitted curve
///
/// **Vocabulary.** A *target* describes the table: its interpolation rule, its permitted deviation
/// from the curve, and the restrictions of the controller for knots. The *binding* requirement is
/// the one that determines the number of knots.
///
/// **Certified.** The error is the exact maximum of |table - curve| and of |table' - curve'|,
/// including the rounding of the knots. It comes from extrema of the difference, not from samples.
///
/// **Fewest.** Knots may be anywhere, not only at the breaks of the curve. First, each interval is
/// made as long as possible. This gives the fewest knots if, for every interval that keeps the
/// tolerance, each part of it also keeps it. Then all intervals are shortened together until they
/// have the same error. For a smooth curve, the result is within a hundredth of the best table with
/// this number of knots. For other curves it is near the best. For tables of at most 64 knots and
/// curves of at most 128 segments there is a further search, over the breaks of the curve and 64
/// divisions of it: no subset of these places is better by more than a hundredth
/// (pvt/src/sample/best_places.hpp). Except for knots at dwells and straight lines, no knot can be
/// removed: two intervals in one would break the tolerance.
///
/// **Dwells and straight lines** of the curve (a slave in step) are exact intervals of the table
/// for every tolerance. The two ends of such an interval are knots; on a grid, the knots are the
/// nearest grid places inside the interval. Between straight lines, as in a table that was recorded
/// in counts, this applies only to dwells of at least 1/64 of the curve. A line is not kept if its
/// rounded ends break the tolerance, and no dwell or line is kept if `spacing` leaves no place.
///
/// **Quadratic pieces.** There is an additional knot in the middle of each interval between two
/// knots of the curve. So the velocity does not step. Every other knot is on the curve, so errors
/// do not accumulate. One piece is enough if the curve is quadratic.
///
/// **Steps.** A knot has one velocity and one acceleration. If those of the curve step, the knot
/// takes the left values (beside a dwell: those of the dwell), and the next interval is as short as
/// necessary.
///
/// **Units** are those of the curve. **Throws** InputError, with the key and a possible value, for
/// a target that cannot be met, for a target without any request, and for negative numbers.

/// Requirements for the table. At least one of `tolerance`, `velocity_tolerance` and `most` is
/// given. Without tolerances, the table has the least position error that is possible with `most`
/// knots.
struct Target {
  Interpolation rule = Interpolation::cubic_hermite;  ///< interpolation of the table
  /// True: pieces of degree 2, for controllers whose segments have linear velocity (Googol's
  /// NORMAL); most intervals need two pieces. Requires cubic_hermite and no rounding (p_step and
  /// v_step 0).
  bool quadratic = false;
  std::optional<double> tolerance = {};  ///< greatest permitted error of the position, > 0
  /// Greatest permitted error of the first derivative, > 0.
  std::optional<double> velocity_tolerance = {};
  std::optional<std::size_t> most = {};  ///< number of knots that the controller can hold, >= 2
  double spacing = 0;                    ///< least distance between knots
  double x_step = 0;  ///< knots are at whole multiples of this step (1 ms, 1 pulse); 0: anywhere
  /// Positions are rounded to whole multiples of this step (counts); 0: not rounded.
  double p_step = 0;
  double v_step = 0;  ///< velocities are rounded to whole multiples of this step; 0: not rounded
};

/// Returns the table with the fewest knots for the target.
///
/// **Rounding.** Positions are rounded, not their increments, so errors do not add up. All
/// increments are whole multiples of the steps, and their sum is the whole travel. A curve that
/// repeats must have a period of a whole number of `x_step` and an advance of a whole number of
/// `p_step`; otherwise it would drift and is rejected. A curve that holds outside ends at the first
/// multiple of `x_step` at or after its end; any other curve must end at such a multiple. The
/// search takes the farthest possible knot. With a tolerance below p_step / 2, knots are at places
/// where the curve is close to whole counts.
///
/// A tolerance below the rounding of the curve's numbers (1e-15 of the sum of a segment's terms)
/// counts as this rounding.
template <class Over>
Sampled reduced(const Curve<Over>& f, const Target& target);

/// Like reduced() above, for a fitted curve. The error of the fit is subtracted from the tolerances
/// and added to the error of the table. Throws InputError if the error of the fit exceeds a
/// tolerance.
template <class Over>
Sampled reduced(const Fitted<Over>& f, const Target& target);

}  // namespace jounce
