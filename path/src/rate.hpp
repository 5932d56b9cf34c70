// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "jounce/profiles/error.hpp"

#include "path/src/tolerances.hpp"

namespace jounce {

/// Throws InputError unless a velocity, acceleration or jerk is large enough for a plan; it may be
/// infinite.
inline void require_rate(const char* key, double value) {
  if (!(value > 0)) throw InputError(key, value, "must be greater than 0");
  if (value < path_detail::least_rate)
    throw InputError(key, value, "must be at least " + number(path_detail::least_rate));
}

}  // namespace jounce
