// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace jounce {

/// Powers as they are written by hand: "mm/deg^2" becomes "mm/deg²", "s^-1" becomes "s⁻¹". Only a
/// `^` between a letter, digit or `)` and an integer is touched.
std::string superscripts(std::string_view text);

/// A number for people, rounded to `digits` significant digits and as short as that allows, with a
/// typographic minus: "−3.39227", "1.5×10¹²". Rounding only in the display: for machines use
/// number().
std::string short_number(double value, int digits = 6);

}  // namespace jounce
