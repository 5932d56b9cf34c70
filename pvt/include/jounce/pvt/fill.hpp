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

/// Rule for velocities that a table omits. Given values are not changed. C2 means that the
/// acceleration is continuous, C4 that the fourth derivative is continuous.
enum class Filling {
  natural,   ///< C2 cubic spline; at an end without a given velocity, acceleration 0
  clamped,   ///< C2 cubic spline; an end without a given velocity is at rest
  periodic,  ///< C2 cubic spline, continuous from the end to the start; the position may advance
  /// C2 cubic spline, with one cubic over the first two intervals and one over the last two.
  not_a_knot,
  monotone,  ///< no overshoot: Fritsch and Butland's harmonic mean (PCHIP)
  /// No overshoot, and convex where the data are convex; otherwise as near to `natural` as
  /// possible.
  shape_preserving,
  minimum_jerk,   ///< the quintic spline (C4), which has the least integral of jerk^2
  within_limits,  ///< each piece is within the limits; otherwise as near to `clamped` as possible
};

/// Returns the word of the spec: "natural", ...
const char* name(Filling filling);
/// Returns the rule of a word; nullopt if unknown.
std::optional<Filling> filling_named(std::string_view name);

/// Input of filled(): a table with some or no velocities (and accelerations).
///
///     FillSpec spec{.x = {0, 2, 3, 4, 6, 11}, .p = {0, 153, 42, 161, 177, 83}};
///     spec.filling = Filling::monotone;
///     Filled made = filled(spec);
///     Trajectory exact = made.table.curve<OverTime>();      // does not overshoot a knot
///     made.report.ok();                                     // false: a requirement is not met
///
/// **Vocabulary.** A *piece* is the motion between two successive knots; its *chord* is the
/// straight line between them. A rule *continues across the ends* if it uses the last piece as the
/// neighbor of the first.
///
/// **Periodic.** `periodic` always continues across the ends. monotone, shape_preserving and
/// minimum_jerk do so if `outside` is wrap or advance. In these cases, the first and the last
/// velocity are equal. The positions at the ends may differ (a rotary axis), except with
/// Extrapolation::wrap.
///
/// **Units.** x: s, or the master's unit m; p: u; v: u/x; a: u/x^2. The limits are in the same
/// units.
///
/// **Throws** InputError with the knot's key, like Table. Also throws for v or a of another size
/// than x; for a given value that is not finite; for an acceleration if the rule has no
/// accelerations; for different values at both ends of a periodic table; for the interpolation
/// linear; for monotone or shape_preserving with an interpolation other than cubic_hermite; for
/// within_limits without limits; and for invalid limits.
struct FillSpec {
  Domain axis = Domain::time;                 ///< meaning of x: time or master position
  std::vector<double> x = {};                 ///< strictly ascending
  std::vector<double> p = {};                 ///< one for each knot
  std::vector<std::optional<double>> v = {};  ///< one for each knot, or empty: no velocity is given
  /// Accelerations, like `v`; only with Interpolation::quintic_hermite.
  std::vector<std::optional<double>> a = {};
  Interpolation rule = Interpolation::cubic_hermite;  ///< cubic_hermite or quintic_hermite
  Filling filling = Filling::natural;                 ///< rule for omitted velocities
  Extrapolation outside = Extrapolation::hold;        ///< policy of the table outside its interval
  Limits limits = {};  ///< for within_limits: velocity, acceleration, jerk
};

/// Result of filled().
struct Filled {
  Table table;  ///< the table with all values
  /// Requirements that the table does not meet, each with its segment and advice. "fill/limits"
  /// (broken): no velocities bring the piece within the limits; the advice gives the time that the
  /// piece needs. "fill/monotone", "fill/convex" (warnings): the piece does not have the shape of
  /// the data, because of given velocities or of the neighboring pieces.
  Report report = {};
};

/// Fills in the velocities and accelerations that the table omits; the time is proportional to the
/// number of knots. Properties of the rules:
/// - natural, clamped, periodic, not_a_knot: the acceleration is continuous at every knot without a
///   given velocity (C. de Boor, A Practical Guide to Splines, ch. IV). Of all curves through the
///   knots with the given velocities, `natural` has the least integral of acceleration^2.
/// - monotone: every piece without a "fill/monotone" finding rises, falls or rests like its chord
///   (Fritsch and Butland 1984).
/// - shape_preserving: like monotone. In addition, a piece bends in one direction if the data
///   around the piece do, unless it has a "fill/convex" finding (C1 cubics cannot always do this).
///   The error is of second order.
/// - minimum_jerk: the least integral of jerk^2 of all curves through the given values (Schoenberg
///   1964). A cubic table gets the same velocities. The stiffness of a piece is its length^-5, so
///   two neighboring intervals of ratio 1 : 65000 cost half of the digits.
/// - within_limits: an end without a given velocity is at rest. A piece without a finding exceeds
///   no limit by more than 1e-13 of the limit.
///
/// With Interpolation::quintic_hermite, the omitted accelerations minimize the integral of jerk^2,
/// for the velocities that the rule gives. within_limits then brings the cubic with these
/// velocities within the limits, not the quintic; check the quintic with check().
Filled filled(const FillSpec& spec);

/// Computes the velocities of the C2 cubic spline through the knots if no velocity is given. Use it
/// for data that need no report. `ends` is natural, clamped (at rest), periodic or not_a_knot.
/// Throws InputError if the spans differ in size, or for fewer than two knots. Requires an x that
/// ascends strictly (not checked). The result is the same on every computer.
void spline_velocities(std::span<const double> x, std::span<const double> p, Filling ends,
                       std::span<double> v);

}  // namespace jounce
