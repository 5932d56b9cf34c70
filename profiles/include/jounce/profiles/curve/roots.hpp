// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "jounce/profiles/curve/curve.hpp"

namespace jounce {

/// Every s in (0, 1) where f vanishes, ascending, appended to `out` (which is cleared first).
///
/// Nothing is sampled: a piece is dropped only when an enclosure of f over it (the hull of its
/// Bernstein coefficients, sines as Taylor polynomials with their remainder) excludes zero, and
/// finished only when the enclosure of f' does, so that the one root in it can be bracketed.
/// `flat` >= 0 is the size below which |f| counts as zero: a stretch where f stays within it yields
/// one point, its middle. A root of even multiplicity yields at least one point within 1e-7.
void roots(const Segment& f, double flat, std::vector<double>& out);

/// Every position where the curve's `order`th derivative (0: the value) takes `level`, ascending,
/// including breaks with the level on one side. A stretch that stays at the level, to rounding,
/// yields its start. Throws InputError for a level that is not finite.
template <class Over>
std::vector<double> crossings(const Curve<Over>& f, int order, double level);

}  // namespace jounce
