// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "jounce/profiles/curve/curve.hpp"
#include "jounce/profiles/curve/extrema.hpp"

namespace jounce {

/// Compares two curves exactly: two versions of a cam, a cam and its table, a motion before and
/// after a filter.
///
///     const Changes changes = compare(before, after);
///     changes[0].largest;                // the largest difference of position, and where it is
///     changes[2].before.peak();          // peak acceleration of the first curve
///     changes[2].after.peak();           // peak acceleration of the second
///     if (changes[1].within(1e-6)) ...   // the velocities agree to a millionth of their range
///     for (const KnotChange& knot : knot_changes(before, after)) ...
///
/// **Vocabulary.** The *difference* is after - before, over the interval that both curves share.
/// Each change is in the unit of its quantity; its place is a time or a master position. *Rounding*
/// is an upper bound of the error that the finite digits of both curves cause at a place. A
/// difference of at most this size counts as zero.
///
/// **Exact.** The difference of two segments is a segment. Its extrema are exact, not found by
/// sampling. If both segments together have more than three sines of different frequency, the piece
/// is divided until the Taylor polynomial of each sine has an error below the rounding.
///
/// **Throws.** The functions throw InputError("interval", ...) if the curves share no interval.

/// The curve after - before, with bounds of its rounding.
template <class Over>
struct Difference {
  Curve<Over> curve;  ///< its policy outside is `refuse`
  /// For each segment of the curve: rounding of the value and of its three derivatives.
  std::vector<Jet> rounding = {};
};
template <class Over>
Difference<Over> difference(const Curve<Over>& before, const Curve<Over>& after);

/// The change of one quantity: of the value or of one of its derivatives.
struct Change {
  /// The signed difference of largest magnitude. A place where the difference is within rounding
  /// counts only if no other place has a larger one.
  Extremum largest = {};
  double rounding = 0;  ///< rounding at the place of `largest`
  Range before = {};    ///< range of the first curve, over its whole length
  Range after = {};     ///< range of the second curve

  /// True if the difference is everywhere within rounding.
  [[nodiscard]] bool none() const;
  /// The reference for a relative difference: the wider of the two ranges.
  [[nodiscard]] double span() const;
  /// True if the difference is at most `share` * span(), or within rounding.
  [[nodiscard]] bool within(double share) const;
};

/// The changes of the value and of its first, second and third derivative.
using Changes = std::array<Change, 4>;

/// Compares two curves over their common interval.
template <class Over>
Changes compare(const Curve<Over>& before, const Curve<Over>& after);

/// A knot that was added or removed, whose time or master position changed, or whose values
/// changed.
struct KnotChange {
  struct Knot {
    std::size_t index = 0;  ///< index in its curve, from 0
    double where = 0;       ///< time or master position
    Jet jet{};  ///< value and derivatives from the right; at the end of the curve from the left
  };

  std::optional<Knot> before = {};  ///< empty: the knot was added
  std::optional<Knot> after = {};   ///< empty: the knot was removed

  /// True if the knot's time or master position changed by more than rounding. False if only one
  /// curve has the knot.
  bool moved = false;
  std::array<bool, 3> changed{};  ///< true if changed: value, first, second derivative
};

/// Returns all changed knots in ascending order. The knots of each curve are given as ascending
/// positions in [start, end]; by default they are its breaks. Knots at the same position (to 1e-12
/// of it) are the same knot. Between two such positions, a knot of `before` and a knot of `after`
/// count as one knot that moved if each is the nearest to the other.
template <class Over>
std::vector<KnotChange> knot_changes(const Curve<Over>& before,
                                     std::span<const double> knots_before, const Curve<Over>& after,
                                     std::span<const double> knots_after);
template <class Over>
std::vector<KnotChange> knot_changes(const Curve<Over>& before, const Curve<Over>& after) {
  return knot_changes(before, before.breaks(), after, after.breaks());
}

}  // namespace jounce
