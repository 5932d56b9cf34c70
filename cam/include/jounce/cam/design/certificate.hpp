// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "jounce/cam/design/rise.hpp"
#include "jounce/profiles/limits/limits.hpp"

namespace jounce {

/// Compares the characteristic values of a rise with their lower bounds. No motion law has a value
/// below its bound; this is proven. (Elsewhere, a certificate is a proven upper bound of an error.)
/// Returns findings of Severity::note. They show how much a cam could be improved.
///
///     Report best = certificates(cam);
///     for (const Finding& f : best.findings)
///       std::printf("%s: %g, bound %g\n", f.quantity.c_str(), f.value, f.limit);
///
/// Each rise (stroke h, length b) has one finding for each rule that applies. The quantities are
/// normalized to h = b = 1. Characteristics defines Cv and Cm. Cj is Characteristics::cj_inside. Ca
/// is max |f''|, the greater of Characteristics::ca and ca_star. A bound applies if the rise is
/// smooth enough. In the column "needs n", n means that the derivatives f' to f^(n-1) are zero at
/// both ends and do not step between them (Rise::smooth >= n - 1).
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
/// | bound/duration | 1/Cv + Cv/Ca + Ca/Cj | at most 1 | 2 without Ca/Cj, 3 with it | seven segments (S-curve) |
///
/// In bound/duration, Cv is max f' in the direction of the stroke. With n = 3 and Ca^2 > Cv Cj, the
/// quantity is 1/Cv + 2 sqrt(Cv/Cj), since the fastest ramp then has no constant acceleration. In a
/// finding of a bound, `value` is the quantity, `limit` its bound, and `margin` the relative excess
/// over the bound (for bound/duration: the shortfall). `where` is the position of the peak, or the
/// start of the rise. `segment` is the first segment of the rise.
///
/// For n >= 2, two more findings state identities that hold for every such motion. Their `margin`
/// is the unused share of the tolerance:
/// - "identity/acceleration": the integral of f'' is the gain of the velocity;
/// - "identity/moment": the integral of (1/2 - z) f'' is 1 - (f'(0) + f'(1)) / 2, where z is the
///   normalized master position.
///
/// No curve can be below a bound (by more than 1e-7) or violate an identity (by more than 1e-9 of
/// its terms). A `broken` finding therefore means inconsistent data, such as pieces that do not
/// join. Never throws.
///
/// The derivations are in the source; the symbols are the symbols of VDI 2143.
Report certificates(const Rise& rise);

/// Returns the findings of all rises of a cam.
Report certificates(const Cam& cam);

}  // namespace jounce
