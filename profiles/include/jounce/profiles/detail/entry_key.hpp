// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>

namespace jounce::profiles_detail {

/// Returns the key of a field in a list, counted from 1: `list[2].field` for i = 1.
inline std::string entry_key(const std::string& list, std::size_t i, const char* field) {
  return list + "[" + std::to_string(i + 1) + "]." + field;
}

}  // namespace jounce::profiles_detail
