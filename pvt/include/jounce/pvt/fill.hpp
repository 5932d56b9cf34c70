// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "jounce/profiles/limits/limits.hpp"
#include "jounce/pvt/table.hpp"

namespace jounce {

/// Rule for velocities that a table leaves out. Each rule keeps given values, bit for bit.
enum class Filling {
  natural,     ///< C2 cubic spline; an end left open has acceleration 0
  clamped,     ///< C2 cubic spline; an end left open is at rest
  periodic,    ///< C2 cubic spline, also from the end to the start; the position may advance
  not_a_knot,  ///< C2 cubic spline, one cubic over the first two intervals and the last two
  monotone,    ///< no overshoot: Fritsch and Butland's harmonic mean (PCHIP)
  shape_preserving,  ///< no overshoot, convex where the data are; otherwise as near to `natural` as possible
  minimum_jerk,   ///< least integral of jerk^2 of a quintic table: the C4 quintic spline
  within_limits,  ///< each piece keeps the limits; as near to `clamped` as that allows
};

/// "natural", ... : the words of the spec.
const char* name(Filling filling);
std::optional<Filling> filling_named(std::string_view name);

/// A table whose velocities (and accelerations) are known here and there, or not at all.
///
///     FillSpec spec{.x = {0, 2, 3, 4, 6, 11}, .p = {0, 153, 42, 161, 177, 83}};
///     spec.filling = Filling::monotone;
///     Filled made = filled(spec);
///     Trajectory exact = made.table.curve<OverTime>();      // does not overshoot a knot
///     made.report.ok();                                     // unmet requirements, by segment
///
/// **Vocabulary.** A *piece* is the motion between two knots; the *chord* is the straight line
/// there. A method *looks across the seam* if it treats the last piece as the neighbor of the
/// first.
///
/// **Periodic.** `periodic` always looks across the seam; monotone, shape_preserving and
/// minimum_jerk do if `outside` repeats; then the first and last velocity are equal. Positions may
/// differ at the ends (a rotary axis), except under Extrapolation::wrap.
///
/// **Units.** x in s or master m; p in u; v in u/x, a in u/x^2; limits accordingly.
///
/// **Throws** InputError with the knot's key like Table; also for v or a of another size than x, a
/// given value that is not finite, an acceleration for a rule without one, ends of one periodic
/// table that differ, monotone or shape_preserving under another rule than cubic_hermite,
/// within_limits without any limit, and invalid limits.
struct FillSpec {
  Domain axis = Domain::time;
  std::vector<double> x;                      ///< strictly ascending
  std::vector<double> p;                      ///< like many
  std::vector<std::optional<double>> v = {};  ///< like many, or none at all: nothing is given
  std::vector<std::optional<double>> a =
      {};  ///< the same; for Interpolation::quintic_hermite alone
  Interpolation rule = Interpolation::cubic_hermite;  ///< not linear, which has nothing to fill in
  Filling filling = Filling::natural;
  Extrapolation outside = Extrapolation::hold;
  Limits limits = {};  ///< velocity, acceleration, jerk: for within_limits
};

struct Filled {
  Table table;
  /// Unmet requirements of the method, each finding with its segment and advice: "fill/limits"
  /// (broken): a piece that no velocities bring within the limits, with the time it needs;
  /// "fill/monotone", "fill/convex" (warnings): a piece for which given velocities, or the pieces
  /// beside it, leave no margin for the shape of the data.
  Report report;
};

/// Fills the table in O(knots).
///
/// *Guarantees.* natural, clamped, periodic, not_a_knot: acceleration continuous at every knot with
/// an omitted velocity (de Boor, A Practical Guide to Splines, ch. IV); of all curves through the
/// knots with the given velocities `natural` has the least integral of acceleration^2. monotone:
/// every piece without a "fill/monotone" finding rises, falls or stays like its chord (Fritsch and
/// Butland 1984). shape_preserving: the same, and a piece between knots whose data bend in one
/// direction bends in that direction (unless "fill/convex" names it; C1 cubics cannot always do
/// this); second order. minimum_jerk: the least integral of jerk^2 over all curves through the
/// given values (Schoenberg 1964); in a cubic table the same velocities. The stiffness of a piece
/// is its length^-5: intervals of 1 : 65000 side by side cost half of the digits. within_limits:
/// ends left open are at rest; a piece not named keeps the limits, to a relative 1e-13.
///
/// With Interpolation::quintic_hermite, for every choice of the velocities, omitted accelerations make the integral
/// of jerk^2 least under these velocities. (within_limits then holds for the cubic; see `check`.)
Filled filled(const FillSpec& spec);

/// Velocities of the C2 cubic spline through the knots, nothing given: the kernel of `filled`, for
/// data that need no report. Ends: natural, clamped (at rest), periodic or not_a_knot. Spans of equal size >= 2,
/// x strictly ascending (not checked). Four chains run side by side; the result is the same
/// on every machine.
void spline_velocities(std::span<const double> x, std::span<const double> p, Filling ends,
                       std::span<double> v);

}  // namespace jounce
