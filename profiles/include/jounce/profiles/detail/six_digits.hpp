// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace jounce {

/// Returns a number for a message, with six significant digits; a whole number below 1e9 has all
/// its digits. Examples: 90000, 26.1799, 4e-5. For a file, number() in error.hpp gives all digits.
std::string six_digits(double value);
/// Like six_digits(), but rounded up or down, so that a limit that a user copies from a message is
/// still satisfied.
std::string six_digits_up(double value);
std::string six_digits_down(double value);
/// Returns a count with its noun, which takes an s unless the count is 1: "1 knot", "6 knots".
template <class Count>
std::string counted(Count count, const std::string& noun) {
  return std::to_string(count) + " " + noun + (count == 1 ? "" : "s");
}

}  // namespace jounce
