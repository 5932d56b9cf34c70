// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <deque>
#include <string>
#include <string_view>

#include "jounce/stream/message/message.hpp"

namespace jounce::machine_detail {

/// Columns that a text takes on a terminal: characters, not bytes.
std::size_t columns(std::string_view text);

/// A text from the wire, made safe for a terminal: no control character, not even one of two bytes.
std::string harmless(std::string_view text, bool ascii);

/// Cut to so many columns; filled up to them.
std::string cut(std::string_view text, std::size_t width);
std::string padded(std::string_view text, std::size_t width);

/// A number with its unit; "not known" for NaN.
std::string valued(double value, const std::string& unit);

/// Filled by a share of 0 to 1.
std::string bar(double share, bool ascii);

/// One character for each value, scaled from the lowest to the highest one; if there are more than
/// `width`, the last ones.
std::string sparkline(const std::deque<double>& values, std::size_t width, bool ascii);

/// A character a class, by the logarithm: or nothing but the most frequent class would be seen.
std::string histogram(const wire::Histogram& counts, bool ascii);

}  // namespace jounce::machine_detail
