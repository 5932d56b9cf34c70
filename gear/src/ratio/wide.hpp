// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cassert>
#include <cstdint>
#include <limits>

/// Division of 128-bit integers, rounded towards minus infinity.
namespace jounce::gear_detail {

__extension__ using Wide = __int128;

struct Division {
  Wide quotient;           // rounded towards minus infinity
  std::int64_t remainder;  // 0 <= remainder < divisor
};

inline Division floor_divide(Wide a, std::int64_t b) {
  Wide q = a / b;
  Wide r = a % b;
  if (r < 0) {
    r += b;
    --q;
  }
  return {q, static_cast<std::int64_t>(r)};
}

constexpr bool fits(Wide a) {
  return a >= std::numeric_limits<std::int64_t>::min() &&
         a <= std::numeric_limits<std::int64_t>::max();
}

inline std::int64_t narrow(Wide a) {
  assert(fits(a));
  return static_cast<std::int64_t>(a);
}

}  // namespace jounce::gear_detail
