// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "jounce/profiles/curve/curve.hpp"
#include "jounce/profiles/curve/extrema.hpp"

namespace jounce {

/// Exact changes from one curve to another: last week's cam and this week's, a cam and its
/// table, a motion before and after an operator.
///
///     const Changes changes = compare(before, after);
///     changes[0].largest;                // the position differs by at most this, and where
///     changes[2].before.peak();          // the peak acceleration it had
///     changes[2].after.peak();           // and has
///     if (changes[1].within(1e-6)) ...   // the velocities agree to a millionth of their range
///     for (const KnotChange& knot : knot_changes(before, after)) ...
///
/// **Vocabulary.** The *difference* is after - before, over the interval that both curves have; a
/// change is in the unit of its quantity; the place of its maximum is a position on their axis.
/// *Rounding* is the greatest effect of rounding in the numbers of both curves at that place: a
/// difference up to it counts as none.
///
/// **Exact**: the difference of two segments is a segment, and its extrema are isolated, not
/// sampled. Where the two have more than three sines of different frequency between them, the piece
/// is cut so short that each sine is its Taylor polynomial to within that rounding.
///
/// **Throws** InputError("interval", ...) for curves without a stretch in common.

/// after - before, piece by piece.
template <class Over>
struct Difference {
  Curve<Over> curve;  ///< refuses outside
  std::vector<Jet>
      rounding;  ///< rounding of each of its segments: of the value and of three derivatives
};
template <class Over>
Difference<Over> difference(const Curve<Over>& before, const Curve<Over>& after);

/// One quantity of two curves: the value, or one of its derivatives.
struct Change {
  /// The difference of largest magnitude, signed. Places where it is within rounding count only if
  /// there is no other.
  Extremum largest;
  double rounding = 0;  ///< at that place
  Range before;         ///< over the whole of each curve
  Range after;

  /// True if there is no difference except for rounding.
  [[nodiscard]] bool none() const;
  /// Reference of a share: the wider of the two ranges.
  [[nodiscard]] double span() const;
  /// True if the difference is at most `share` of the span, or none.
  [[nodiscard]] bool within(double share) const;
};

/// Value, first, second and third derivative.
using Changes = std::array<Change, 4>;

template <class Over>
Changes compare(const Curve<Over>& before, const Curve<Over>& after);

/// A knot that was added, removed, moved along the axis, or that carries other values.
struct KnotChange {
  struct Knot {
    std::size_t index = 0;  ///< among the knots of its curve, counted from 0
    double where = 0;
    Jet jet{};  ///< right limits; at the end of the curve left ones
  };

  std::optional<Knot> before = {};  ///< none: added
  std::optional<Knot> after = {};   ///< none: removed

  /// True if its place, value, velocity or acceleration changed by more than rounding; false if
  /// only one curve has the knot.
  bool moved = false;
  std::array<bool, 3> changed{};
};

/// All changed knots in the order of the axis. Knots at one place (to 1e-12 of it) are one knot; of
/// those left between two that stayed, two are one knot that moved if each is the other's nearest.
/// Knots are ascending places in [start, end] of their curve, by default its breaks.
template <class Over>
std::vector<KnotChange> knot_changes(const Curve<Over>& before,
                                     std::span<const double> knots_before, const Curve<Over>& after,
                                     std::span<const double> knots_after);
template <class Over>
std::vector<KnotChange> knot_changes(const Curve<Over>& before, const Curve<Over>& after) {
  return knot_changes(before, before.breaks(), after, after.breaks());
}

}  // namespace jounce
