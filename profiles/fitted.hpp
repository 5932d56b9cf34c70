#pragma once

#include "jounce/profiles/curve.hpp"

namespace jounce {

/// A curve that stands for a function which fits no Segment, and how far it strays at the most.
///
///     Fitted<OverMaster> slave = composed_within(cam, camshaft, 1e-9);   // degree 25: not exact
///     double strays = slave.error[0];                   // <= 1e-9, certified
///     double jerk_strays = slave.error[3];
///     Report report = check(slave.curve, limits);       // a curve like any other
///
/// **How.** Piecewise polynomials of degree 11 that take the function's value and its first five
/// derivatives at both ends of each piece: the joints are as smooth as the function itself. Pieces
/// are halved until the bound meets the tolerance; what fits exactly stays exact.
///
/// **Certified**: `error` bounds |curve - function| and the same for the first three derivatives,
/// from a bound of the twelfth derivative over the whole piece, not from samples. Rounding, about
/// 1e-14 of the magnitude (1e-11 for the jerk), comes on top.
template <class Over>
struct Fitted {
  Curve<Over> curve;
  Jet error{};  ///< units of the value and its derivatives
};

/// f without sines. Throws InputError unless tolerance > 0 and above the rounding of f (1e-14 of its
/// magnitude).
template <class Over>
Fitted<Over> polynomial_within(const Curve<Over>& f, double tolerance);

/// outer(inner(x)) for any degrees and sines: as `composed`, exact on every piece where that fits.
/// Throws InputError as polynomial_within does, and "inner" as `composed` does.
template <class Outer, class Inner>
Fitted<Inner> composed_within(const Curve<Outer>& outer, const Curve<Inner>& inner,
                              double tolerance);

}  // namespace jounce
