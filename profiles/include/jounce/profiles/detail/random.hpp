// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace jounce::profiles_detail {

/// Returns the next 64 bits of splitmix64 (G. Steele, D. Lea, C. Flood, OOPSLA 2014). Every machine
/// and every library gives the same sequence.
constexpr std::uint64_t splitmix64(std::uint64_t& state) {
  std::uint64_t z = (state += 0x9e3779b97f4a7c15U);
  z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9U;
  z = (z ^ (z >> 27U)) * 0x94d049bb133111ebU;
  return z ^ (z >> 31U);
}

/// Returns a number in [0, 1) with 53 random bits, uniformly distributed.
constexpr double uniform(std::uint64_t& state) {
  return static_cast<double>(splitmix64(state) >> 11U) * 0x1p-53;
}

}  // namespace jounce::profiles_detail
