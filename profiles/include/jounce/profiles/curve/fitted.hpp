// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "jounce/profiles/curve/curve.hpp"

namespace jounce {

/// A curve that approximates a function, with a bound of its error. It stands for a function that
/// does not fit a Segment.
///
///     Fitted<OverMaster> slave = composed_within(cam, camshaft, 1e-9);   // degree 25: not exact
///     double error = slave.error[0];                    // <= 1e-9, certified
///     double jerk_error = slave.error[3];
///     Report report = check(slave.curve, limits);       // a curve like any other
///
/// **How.** The curve consists of polynomials of degree 11. At both ends of each piece, the
/// polynomial has the value and the first five derivatives of the function, so the breaks are as
/// smooth as the function. Pieces are halved until the error bound is within the tolerance. A piece
/// of the function that fits a Segment is exact.
///
/// **Certified.** `error` bounds |curve - function| and the errors of the first three derivatives.
/// Each bound follows from a bound of the twelfth derivative over the whole piece, not from
/// samples. Rounding is not included: about 1e-14 of the magnitude of the value. For the derivative
/// of order k, on a piece of length 1, rounding is 10^k times as large.
template <class Over>
struct Fitted {
  Curve<Over> curve;
  Jet error{};  ///< bounds of the errors of the value and of its three derivatives, in their units
};

/// Returns f with polynomials in place of its sines. Throws InputError("tolerance", ...) unless the
/// tolerance (in the unit of the value) is positive and above rounding (1e-14 of the magnitude of
/// f), and if more than 1e6 pieces would be necessary.
template <class Over>
Fitted<Over> polynomial_within(const Curve<Over>& f, double tolerance);

}  // namespace jounce
