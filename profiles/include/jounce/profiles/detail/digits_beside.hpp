// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace jounce {

/// Returns six_digits(value), or as many more digits as show that the number is not the one in
/// `other`. If no digits show it, the result is 17 digits. Example: beside "50000", the value
/// 50000.04 is 50000.04.
std::string digits_beside(double value, const std::string& other);

}  // namespace jounce
