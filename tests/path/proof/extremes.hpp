// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "jounce/profiles/curve/segment.hpp"

namespace jounce::path_proof {

/// Result of bounded(): the greatest value found, and whether the limit holds.
struct Bounded {
  double largest = 0;  ///< greatest magnitude at an evaluated place
  bool holds = true;   ///< true: proven for every place
};

/// Proves |f^(order)| <= limit over a whole segment, without code of the program: Bernstein coefficients enclose a
/// polynomial, and halving the segment narrows them; a sine has its extremes at quarter turns. Does not accept a sine
/// with a polynomial above degree 1.
Bounded bounded(const Segment& f, int order, double limit);

}  // namespace jounce::path_proof
