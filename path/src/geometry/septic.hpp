// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "jounce/profiles/curve/segment.hpp"

namespace jounce {

/// The polynomial of degree 7 with the value and three derivatives (with respect to u) of a
/// function f at both ends, s in [0, 1]:
///
///     |f - p| = |f^(8)(z)| / 8! (s (1 - s))^4 <= septic_error * max |f^(8)| / 8!,    f^(8) by s
Segment septic(double length, const Jet& a, const Jet& b);
inline constexpr double septic_error = 1.0 / 256;

}  // namespace jounce
