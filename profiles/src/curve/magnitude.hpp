// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "jounce/profiles/error.hpp"

#include "profiles/src/solver/span.hpp"

namespace jounce::profiles_detail {

/// Throws InputError unless a value that may be zero is at most the greatest.
inline void require_moderate(const std::string& key, double value) {
  require_finite(key.c_str(), value);
  if (!is_moderate(value)) throw InputError(key, value, "must be at most 1e30 in magnitude");
}

/// Throws InputError unless a limit (> 0) is within the range.
inline void require_limit(const std::string& key, double value) {
  require_positive(key.c_str(), value);
  if (!is_magnitude(value)) throw InputError(key, value, "must be between 1e-30 and 1e30");
}

}  // namespace jounce::profiles_detail
