// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace jounce {

/// Returns the text with superscripts: "mm/deg^2" becomes "mm/deg²", "s^-1" becomes "s⁻¹". Only a
/// `^` between a letter, digit or `)` and an integer is replaced.
std::string superscripts(std::string_view text);

/// Returns a number for people, rounded to `digits` significant digits, in its shortest form, with
/// a typographic minus: "−3.39227", "1.5×10¹²". For programs, use number().
std::string short_number(double value, int digits = 6);

}  // namespace jounce
