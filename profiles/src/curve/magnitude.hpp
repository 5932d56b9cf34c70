// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "jounce/profiles/error.hpp"

#include "profiles/src/solver/span.hpp"

namespace jounce::profiles_detail {

/// Throws InputError if a value, which may be zero, exceeds the greatest permitted magnitude.
inline void require_moderate(const std::string& key, double value) {
  require_finite(key.c_str(), value);
  if (!is_moderate(value)) throw InputError(key, value, "must be at most 1e30 in magnitude");
}

/// Throws InputError if a limit (> 0) is outside the permitted range.
inline void require_limit(const std::string& key, double value) {
  require_positive(key.c_str(), value);
  if (!is_magnitude(value)) throw InputError(key, value, "must be between 1e-30 and 1e30");
}

}  // namespace jounce::profiles_detail
