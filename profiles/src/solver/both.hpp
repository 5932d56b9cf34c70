// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "jounce/profiles/detail/lanes.hpp"

namespace jounce::profiles_detail {

/// Two results, one from each lane of a comparison. Uses SSE2 instructions, because GCC without
/// SSE4 separates the lanes of a Mask<Vector2>.
class Both {
 public:
#ifdef __SSE2__
  using Bits = __m128d;
  JOUNCE_INLINE static Both at_most(Vector2 a, Vector2 b) {
    return {_mm_cmple_pd(a, b)};
  }
  JOUNCE_INLINE static Both equal(Vector2 a, Vector2 b) {
    return {_mm_cmpeq_pd(a, b)};
  }
  JOUNCE_INLINE Both operator&(Both b) const {
    return {_mm_and_pd(bits_, b.bits_)};
  }
  JOUNCE_INLINE Both operator|(Both b) const {
    return {_mm_or_pd(bits_, b.bits_)};
  }
  [[nodiscard]] JOUNCE_INLINE bool hold() const {
    return _mm_movemask_pd(bits_) == 3;
  }
#else
  using Bits = Mask<Vector2>;
  JOUNCE_INLINE static Both at_most(Vector2 a, Vector2 b) {
    return {a <= b};
  }
  JOUNCE_INLINE static Both equal(Vector2 a, Vector2 b) {
    return {a == b};
  }
  JOUNCE_INLINE Both operator&(Both b) const {
    return {bits_ & b.bits_};
  }
  JOUNCE_INLINE Both operator|(Both b) const {
    return {bits_ | b.bits_};
  }
  [[nodiscard]] JOUNCE_INLINE bool hold() const {
    return (bits_[0] & bits_[1]) != 0;
  }
#endif

 private:
  JOUNCE_INLINE Both(Bits bits) : bits_(bits) {}

  Bits bits_;
};

}  // namespace jounce::profiles_detail
