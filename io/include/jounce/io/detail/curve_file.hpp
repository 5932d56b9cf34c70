// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "jounce/base/hash.hpp"
#include "jounce/profiles/curve/curve.hpp"

namespace jounce {

/// Returns an exact curve as JSON, for other programs. Each segment has its length, the
/// coefficients of its polynomial in s = u / length, where u is the distance from its start, and
/// its sine terms [amplitude, angle, phase] (see Segment).
template <class Over>
std::string curve_json(const Curve<Over>& curve, const Units& units);

}  // namespace jounce
