// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "jounce/cam/design/rise.hpp"
#include "jounce/profiles/limits/limits.hpp"

namespace jounce {

/// Bounds that no law can beat, as notes: the possible improvement.
///
///     Report best = certificates(cam);
///     for (const Finding& f : best.findings)
///       std::printf("%s is %.1f %% above the least\n", f.quantity.c_str(), 100 * f.margin);
///
/// For each rise of stroke h over length b, in the normalised quantities of Characteristics (no
/// unit), as far as its ends and joints allow (n derivatives: f' ... f^(n-1) are zero at both ends
/// and do not step in between):
///
/// | rule | quantity | bound | needs n | attained by |
/// |---|---|---|---|---|
/// | bound/velocity | Cv | 1 | 1 | straight line |
/// | bound/acceleration | Ca | 4 | 2 | parabola |
/// | bound/jerk | Cj | 32 | 3 | perfect spline |
/// | bound/jounce | max f'''' | 384 | 4 | perfect spline |
/// | bound/square_velocity, ..._acceleration, ..._jerk, ..._jounce | mean square | 1, 12, 720, 100800 | 1 ... 4 | line, 2-3, 3-4-5, 4-5-6-7 |
/// | bound/power | Cm | 9/4 | 2 | constant power |
/// | bound/acceleration_for_jerk | Ca | (Cj/4)(1 - sqrt(1 - 32/Cj)) | 3 | trapezoidal f'' |
/// | bound/duration | 1/Cv + Cv/Ca + Ca/Cj | at most 1 | 2, for Cj 3 | seven segments (S-curve) |
///
/// `value` and `limit` are the quantity and its bound, `margin` the share by which it is above
/// (bound/duration: below). `where` is the peak's place, or the rise's start; `segment` the one that
/// the rise begins with.
///
/// Two identities of every motion, likewise: "identity/acceleration", the integral of f'' is what the
/// velocity gains; "identity/moment", that of (1/2 - z) f'' is 1 - (f'(0) + f'(1)) / 2.
///
/// A curve cannot be below a bound or miss an identity (beyond 1e-7, resp. 1e-9 of the terms): a
/// finding that is `broken` means that the data are not what they claim to be, for instance
/// pieces that do not join. Never throws.
///
/// The derivations stand beside the code; the letters are VDI 2143's.
Report certificates(const Rise& rise);

/// Those of every rise.
Report certificates(const Cam& cam);

}  // namespace jounce
