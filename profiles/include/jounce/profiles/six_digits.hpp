// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace jounce {

/// A number for a message, rounded to six significant digits; whole numbers below 1e9 in full: 90000, 26.1799, 4e-5.
/// number() in error.hpp gives all digits instead, for a file.
std::string six_digits(double value);
/// The same, rounded up or down: a bound that keeps the rule when it is typed in.
std::string six_digits_up(double value);
std::string six_digits_down(double value);

}  // namespace jounce
