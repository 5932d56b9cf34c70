// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "jounce/profiles/curve/curve.hpp"

namespace jounce {

/// A curve that approximates a function which fits no Segment, and its greatest error.
///
///     Fitted<OverMaster> slave = composed_within(cam, camshaft, 1e-9);   // degree 25: not exact
///     double strays = slave.error[0];                   // <= 1e-9, certified
///     double jerk_strays = slave.error[3];
///     Report report = check(slave.curve, limits);       // a curve like any other
///
/// **How.** Piecewise polynomials of degree 11 that take the function's value and its first five
/// derivatives at both ends of each piece: the joints are as smooth as the function itself. Pieces
/// are halved until the bound meets the tolerance; a piece that fits exactly stays exact.
///
/// **Certified**: `error` bounds |curve - function| and the same for the first three derivatives,
/// from a bound of the twelfth derivative over the whole piece, not from samples. Rounding comes on
/// top: some 1e-14 of the magnitude, times 10^order for the derivatives of a piece of length 1.
template <class Over>
struct Fitted {
  Curve<Over> curve;
  Jet error{};  ///< units of the value and its derivatives
};

/// f without sines. Throws InputError "tolerance" unless it is positive and above the rounding of f,
/// 1e-14 of its magnitude.
template <class Over>
Fitted<Over> polynomial_within(const Curve<Over>& f, double tolerance);

}  // namespace jounce
