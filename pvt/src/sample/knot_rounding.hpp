// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "jounce/profiles/curve/extrema.hpp"

namespace jounce::pvt_detail {

/// The greatest error of the position of a knot: e P by its own rounding, and V e X by that of its
/// place, with the greatest position P, velocity V and place X of the curve.
template <class Over>
double knot_rounding(const Curve<Over>& f) {
  const double farthest = std::max(std::abs(f.start()), std::abs(f.end()));
  return std::numeric_limits<double>::epsilon() *
         (std::abs(extrema(f, 0).peak().value) + std::abs(extrema(f, 1).peak().value) * farthest);
}

}  // namespace jounce::pvt_detail
