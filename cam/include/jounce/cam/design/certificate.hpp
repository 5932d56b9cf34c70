// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "jounce/cam/design/rise.hpp"
#include "jounce/profiles/limits/limits.hpp"

namespace jounce {

/// Lower bounds of the characteristic values over all motion laws, as notes. They show how much a
/// cam could be improved.
///
///     Report best = certificates(cam);
///     for (const Finding& f : best.findings)
///       std::printf("%s is %.1f %% above the least\n", f.quantity.c_str(), 100 * f.margin);
///
/// There is one finding of each rule for each rise, of stroke h over length b. The quantities are
/// normalized to h = b = 1, as in Characteristics. A bound applies if the rise is smooth enough: n
/// means that the derivatives f' to f^(n-1) are zero at both ends and do not step between them.
///
/// | rule | quantity | bound | needs n | attained by |
/// |---|---|---|---|---|
/// | bound/velocity | Cv | 1 | 1 | straight line |
/// | bound/acceleration | Ca | 4 | 2 | parabola |
/// | bound/jerk | Cj | 32 | 3 | perfect spline |
/// | bound/jounce | max f'''' | 384 | 4 | perfect spline |
/// | bound/square_velocity | mean square f' | 1 | 1 | straight line |
/// | bound/square_acceleration | mean square f'' | 12 | 2 | 2-3 |
/// | bound/square_jerk | mean square f''' | 720 | 3 | 3-4-5 |
/// | bound/square_jounce | mean square f'''' | 100800 | 4 | 4-5-6-7 |
/// | bound/power | Cm | 9/4 | 2 | constant power |
/// | bound/acceleration_for_jerk | Ca | (Cj/4)(1 - sqrt(1 - 32/Cj)) | 3 | trapezoidal f'' |
/// | bound/duration | 1/Cv + Cv/Ca + Ca/Cj | at most 1 | 2, for Cj 3 | seven segments (S-curve) |
///
/// In a finding, `value` is the quantity, `limit` its bound, and `margin` the relative excess over
/// the bound (for bound/duration: the shortfall). `where` is the position of the peak, or the start
/// of the rise. `segment` is the first segment of the rise.
///
/// Two more findings state identities that hold for every motion:
/// - "identity/acceleration": the integral of f'' is the gain of the velocity;
/// - "identity/moment": the integral of (1/2 - z) f'' is 1 - (f'(0) + f'(1)) / 2, where z is the
///   normalized master position.
///
/// No curve can be below a bound (by more than 1e-7) or violate an identity (by more than 1e-9 of
/// its terms). A `broken` finding therefore means inconsistent data, such as pieces that do not
/// join. Never throws.
///
/// The derivations are in the source; the symbols are those of VDI 2143.
Report certificates(const Rise& rise);

/// The certificates of all rises of a cam.
Report certificates(const Cam& cam);

}  // namespace jounce
