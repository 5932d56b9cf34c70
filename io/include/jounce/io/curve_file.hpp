// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "jounce/base/hash.hpp"
#include "jounce/profiles/curve/curve.hpp"

namespace jounce {

/// The exact curve as JSON, for other programs: for each segment its length, the coefficients of
/// its polynomial in s = u / length, and its sine terms [amplitude, angle, phase] (see Segment).
template <class Over>
std::string curve_json(const Curve<Over>& curve, const Units& units);

}  // namespace jounce
