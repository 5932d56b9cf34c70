// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "jounce/profiles/curve/segment.hpp"

namespace jounce::cam_detail {

/// The first three derivatives of a segment. A linear combination of them is a segment again: its sines are the same.
struct Derivatives {
  explicit Derivatives(const Segment& f)
      : first(derivative(f)), second(derivative(first)), third(derivative(second)) {}

  [[nodiscard]] Segment weighted(const std::array<double, 3>& weights) const {
    return *sum(*sum(scaled(first, weights[0]), scaled(second, weights[1])),
                scaled(third, weights[2]));
  }

  Segment first;
  Segment second;
  Segment third;
};

}  // namespace jounce::cam_detail
