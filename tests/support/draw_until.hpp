// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <stdexcept>

namespace jounce::test {

/// Draws until a value is accepted. Throws std::runtime_error if a million draws are not.
template <class Draw, class Accept>
auto draw_until(Draw draw, Accept accept) {
  for (int i = 0; i < 1'000'000; ++i)
    if (auto drawn = draw(); accept(drawn)) return drawn;
  throw std::runtime_error("none of 1000000 random draws is accepted");
}

}  // namespace jounce::test
