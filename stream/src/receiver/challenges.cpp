// SPDX-License-Identifier: Apache-2.0
#include "stream/src/receiver/challenges.hpp"

namespace jounce {

/// Draws another number each time, and at each boot: SplitMix64 maps 64-bit numbers one to one. It
/// need not be secret: with a key, only its holders can sign for it; without a key, any sender may
/// command.
std::int64_t Challenges::draw() {
  std::int64_t drawn = 0;
  while (drawn <= 0) {
    auto z = static_cast<std::uint64_t>(boot_) +
             static_cast<std::uint64_t>(++drawn_) * 0x9E3779B97F4A7C15U;
    z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9U;
    z = (z ^ (z >> 27U)) * 0x94D049BB133111EBU;
    drawn = static_cast<std::int64_t>(z ^ (z >> 31U));
  }
  return drawn;
}

}  // namespace jounce
