// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <utility>

#include "jounce/profiles/curve/segment.hpp"

namespace jounce {

/// An interval that contains the scalar product of two vectors of polynomials over s in [0, 1]: the
/// range of its Bernstein coefficients.
std::pair<double, double> hull_of_products(std::span<const Segment> f, std::span<const Segment> g);

/// The same for the square of their first derivatives with respect to q.
std::pair<double, double> hull_of_speed_squared(std::span<const Segment> axes);

}  // namespace jounce
