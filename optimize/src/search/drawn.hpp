// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace jounce::optimizer {

/// splitmix64 (G. Steele, D. Lea, C. Flood, OOPSLA 2014), uniform in [0, 1): the same numbers on every
/// machine and library.
inline double drawn(std::uint64_t& state) {
  std::uint64_t z = (state += 0x9e3779b97f4a7c15U);
  z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9U;
  z = (z ^ (z >> 27U)) * 0x94d049bb133111ebU;
  return static_cast<double>((z ^ (z >> 31U)) >> 11U) * 0x1p-53;
}

}  // namespace jounce::optimizer
