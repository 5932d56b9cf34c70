// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdio>
#include <string>

namespace jounce {

/// A number for messages, with six digits. number() writes all digits.
inline std::string six_digits(double value) {
  char text[32];
  static_cast<void>(std::snprintf(text, sizeof text, "%.6g", value));
  return text;
}

}  // namespace jounce
