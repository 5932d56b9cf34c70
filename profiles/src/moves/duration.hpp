// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "jounce/profiles/error.hpp"

namespace jounce::profiles_detail {

/// Throws the InputError of a move whose duration a double cannot hold: 0, infinite or not a number.
[[noreturn]] inline void refuse_duration(double to, double duration) {
  // Below 1e-300, a distance loses its digits, and the duration is not a number.
  throw InputError("to", to,
                   duration > 0 ? "is too far from `from`: the duration would exceed 1.8e308"
                                : "is too close to `from`: the move would be too short to compute");
}

}  // namespace jounce::profiles_detail
