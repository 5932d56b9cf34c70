// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cassert>

#include "jounce/profiles/curve/segment.hpp"

namespace jounce::cam_detail {

/// Returns f + g. Sines of both must have the same frequencies, as in the shapes of one piece.
inline Segment added(const Segment& f, const Segment& g) {
  const auto total = sum(f, g);
  assert(total && "sines of one piece have the same frequencies");
  return *total;
}

}  // namespace jounce::cam_detail
