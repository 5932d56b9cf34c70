// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <utility>

#include "jounce/profiles/curve/segment.hpp"

namespace jounce {

/// An interval that contains the sum of the squares of polynomials over s in [0, 1]: the range of
/// its Bernstein coefficients (of twice the degree).
std::pair<double, double> hull_of_squares(std::span<const Segment> axes);

/// The same for their first derivatives with respect to q.
std::pair<double, double> hull_of_speed_squared(std::span<const Segment> axes);

}  // namespace jounce
