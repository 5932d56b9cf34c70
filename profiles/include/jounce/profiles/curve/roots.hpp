// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "jounce/profiles/curve/curve.hpp"

namespace jounce {

/// Writes every s in (0, 1) where f vanishes to `out`, in ascending order. `out` is cleared first.
///
/// Nothing is sampled. The function computes an *enclosure* of f over a piece: an interval that
/// contains all values of f there. A piece is discarded only if the enclosure of f excludes zero. A
/// piece is finished only if the enclosure of f' excludes zero, so that the piece has at most one
/// root, which is then bracketed. The enclosure is the hull of the Bernstein coefficients, with
/// each sine replaced by its Taylor polynomial and remainder.
///
/// `flat` >= 0 is the size below which |f| counts as zero. A stretch on which |f| stays below
/// `flat` gives one point: its middle. A root of even multiplicity gives at least one point within
/// 1e-7 of the root.
void roots(const Segment& f, double flat, std::vector<double>& out);

/// Returns every position where the derivative of this order (0: the value) equals `level`, in
/// ascending order. A break counts if the derivative reaches the level on one of its sides. A
/// segment that stays at the level (to rounding) gives one position, its start. Throws InputError
/// if the level is not finite, or the order is not from 0 to 3.
template <class Over>
std::vector<double> crossings(const Curve<Over>& f, int order, double level);

}  // namespace jounce
