// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>

#include "jounce/profiles/curve/fitted.hpp"
#include "jounce/pvt/sample.hpp"

namespace jounce {

/// Tables of as few knots as do: a curve, or a table of too many knots, for what a controller holds.
///
///     Sampled table = reduced(cam, {.rule = Interpolation::cubic_hermite, .tolerance = 1e-3});
///     table.table.size();            // knots: as few as keep the cam within a micrometre
///     table.error.velocity;          // certified, like table.error.position
///     reduced(cam, {.rule = Interpolation::linear, .most = 17, .x_step = 1});       // the best of 17 points
///     reduced(old.curve<OverMaster>(), {.tolerance = 1e-3, .p_step = 1});  // in whole counts
///     reduced(composed_within(cam, camshaft, 1e-6), {.tolerance = 1e-3});  // what fits no segment
///
/// **Vocabulary.** A *target* is what the table is for: its rule, how far it may stray from the curve,
/// and what the controller's knots can be. A *binding* target is which of these made it as long as it is.
///
/// **Certified.** The error is the exact maximum of |table - curve| and of |table' - curve'|, what the
/// rounding of the knots does to them included: extrema of the difference, none sampled.
///
/// **Fewest.** Knots lie anywhere, not only at the breaks of the curve. Each interval is as long as
/// it can be, which is fewest wherever a part of an interval that keeps the tolerance keeps it too;
/// then all are shortened alike until they share one error: for a smooth curve the table is the best of
/// its number of knots, to a hundredth. Elsewhere it is near the best; tables of at most 64 knots of
/// curves of at most 128 segments are also searched over the breaks of the curve and 64 parts of it, so
/// that no subset of its own knots is better by more than a hundredth (detail/best_places.hpp). No other
/// knot than those of dwells and straight lines can be left out: two intervals as one break the
/// tolerance.
///
/// **Dwells and straight lines** of the curve (a slave in sync) are intervals of the table, exactly,
/// for every tolerance: both ends are knots, on a grid the next ones inwards. Between straight lines,
/// as in a table that was recorded in counts, only dwells of 1/64 of the curve and more. A line gives
/// way where rounding its ends breaks the tolerance; any stretch where `spacing` leaves no place.
///
/// **Quadratic pieces.** A knot of the curve is followed by one of two pieces' own, in the middle of the
/// interval: without a step of the velocity, and on the curve at every other knot, so that no error is
/// handed on. One piece does where the curve is quadratic itself.
///
/// **Steps.** A knot has one velocity and one acceleration. Where the curve's step, a knot takes the
/// left ones (beside a dwell, the dwell's) and the next interval is as short as it must be.
///
/// **Units**: those of the curve. **Throws** InputError, naming the key and what would do, for a
/// target that cannot be met, and for one that asks for nothing or for numbers below 0.

/// Target of the table. `tolerance`, `velocity_tolerance` or `most` must be given; without
/// tolerances the position error is the least that `most` knots can have.
struct Target {
  Interpolation rule = Interpolation::cubic_hermite;
  /// Pieces of degree 2, as a controller's segments of linear velocity are (Googol's NORMAL): two for
  /// most intervals. Of a cubic_hermite table, in numbers that are not rounded.
  bool quadratic = false;
  std::optional<double> tolerance = {};           ///< greatest position error, > 0
  std::optional<double> velocity_tolerance = {};  ///< greatest error of the first derivative, > 0
  std::optional<std::size_t> most = {};           ///< knots that the controller holds, >= 2
  double spacing = 0;                             ///< least distance of knots
  double x_step = 0;  ///< knots at whole multiples of it (1 ms, 1 pulse); 0: anywhere
  double p_step = 0;  ///< positions rounded to whole multiples of it (counts); 0: as they are
  double v_step = 0;  ///< velocities likewise
};

/// The table of fewest knots for the target.
///
/// **Rounding.** Positions are rounded where they are, not their increments, so that no error
/// adds up: increments are whole and sum to the whole travel. A curve that repeats must have a period
/// of whole `x_step` and advance by whole `p_step`, or it would drift, and is refused. A curve that
/// holds outside ends at the first multiple of `x_step` from its end on; another one must end at one.
/// Of the knots that the rounding leaves possible, the farthest is taken: a tolerance
/// below p_step / 2 makes knots where the curve passes close by whole counts.
///
/// A tolerance below the rounding of the curve's numbers (1e-15 of the sum of a segment's terms)
/// counts as that rounding.
template <class Over>
Sampled reduced(const Curve<Over>& f, const Target& target);

/// The same for what was fitted first: its error is taken off the tolerances, and added to the
/// table's. Throws InputError for a tolerance that the fit alone uses up.
template <class Over>
Sampled reduced(const Fitted<Over>& f, const Target& target);

}  // namespace jounce
