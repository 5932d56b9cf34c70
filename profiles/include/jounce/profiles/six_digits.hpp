// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace jounce {

/// A number for a message, with six significant digits; a whole number below 1e9 has all its
/// digits. Examples: 90000, 26.1799, 4e-5. For a file, number() in error.hpp gives all digits.
std::string six_digits(double value);
/// The same, rounded up or down: a user who copies the bound from a message keeps the rule.
std::string six_digits_up(double value);
std::string six_digits_down(double value);

}  // namespace jounce
