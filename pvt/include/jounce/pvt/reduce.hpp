// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>

#include "jounce/profiles/curve/fitted.hpp"
#include "jounce/pvt/sample.hpp"

namespace jounce {

/// Tables of the fewest knots: a curve, or a table with too many knots, reduced to the capacity of
/// a controller.
///
///     Sampled table = reduced(cam, {.rule = Interpolation::cubic_hermite, .tolerance = 1e-3});
///     table.table.size();            // the fewest knots that keep the cam within a micrometre
///     table.error.velocity;          // certified, like table.error.position
///     reduced(cam, {.rule = Interpolation::linear, .most = 17, .x_step = 1});       // the best of 17 points
///     reduced(old.curve<OverMaster>(), {.tolerance = 1e-3, .p_step = 1});  // in whole counts
///     reduced(composed_within(cam, camshaft, 1e-6), {.tolerance = 1e-3});  // a curve that fits no segment
///
/// **Vocabulary.** A *target* describes the table: its rule, its permitted deviation from the
/// curve, and the possible knots of the controller. The *binding* requirement is the one that
/// determines the number of knots.
///
/// **Certified.** The error is the exact maximum of |table - curve| and of |table' - curve'|,
/// including the rounding of the knots: extrema of the difference, not samples.
///
/// **Fewest.** Knots lie anywhere, not only at the breaks of the curve. Each interval is as long as
/// it can be, which is fewest wherever a part of an interval that keeps the tolerance keeps it too;
/// then all are shortened alike until they share one error: for a smooth curve the table is the
/// best of its number of knots, to a hundredth. Otherwise it is near the best; tables of at most 64
/// knots of curves of at most 128 segments are also searched over the breaks of the curve and 64
/// parts of it, so that no subset of its own knots is better by more than a hundredth
/// (detail/best_places.hpp). No other knot than those of dwells and straight lines can be left out:
/// two intervals as one break the tolerance.
///
/// **Dwells and straight lines** of the curve (a slave in sync) are intervals of the table,
/// exactly, for every tolerance: both ends are knots, on a grid the next ones inwards. Between
/// straight lines, as in a table that was recorded in counts, only dwells of 1/64 of the curve and
/// more. A line is not kept if its rounded ends break the tolerance; no stretch is kept if
/// `spacing` leaves no place.
///
/// **Quadratic pieces.** Between two knots of the curve there is a knot of the table's own, in the
/// middle of the interval: without a step of the velocity, and on the curve at every other knot, so
/// no error is passed on. One piece is enough if the curve itself is quadratic.
///
/// **Steps.** A knot has one velocity and one acceleration. If those of the curve step, a knot
/// takes the left values (beside a dwell, those of the dwell) and the next interval is as short as
/// necessary.
///
/// **Units**: those of the curve. **Throws** InputError, with the key and a value that works, for a
/// target that cannot be met, and for one without a request or with numbers below 0.

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
/// **Rounding.** Positions are rounded, not their increments, so no error adds up: increments are
/// whole and sum to the whole travel. A curve that repeats must have a period of whole `x_step` and
/// advance by whole `p_step`; otherwise it would drift, and is rejected. A curve that holds outside
/// ends at the first multiple of `x_step` from its end on; another one must end at one. The search
/// takes the farthest knot that rounding permits: a tolerance below p_step / 2 makes knots at
/// places where the curve is close to whole counts.
///
/// A tolerance below the rounding of the curve's numbers (1e-15 of the sum of a segment's terms)
/// counts as that rounding.
template <class Over>
Sampled reduced(const Curve<Over>& f, const Target& target);

/// The same for a fitted curve: the error of the fit is subtracted from the tolerances, and added
/// to that of the table. Throws InputError if the fit alone uses up a tolerance.
template <class Over>
Sampled reduced(const Fitted<Over>& f, const Target& target);

}  // namespace jounce
