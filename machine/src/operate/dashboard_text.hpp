// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <deque>
#include <string>
#include <string_view>

#include "jounce/stream/message/message.hpp"

namespace jounce::machine_detail {

/// Returns the number of columns that a text takes on a terminal: characters, not bytes.
std::size_t columns(std::string_view text);

/// Returns a text from the wire without control characters, even control characters of two bytes:
/// the text is safe for a terminal.
std::string harmless(std::string_view text, bool ascii);

/// cut() shortens a text to `width` columns; padded() also fills it up with spaces.
std::string cut(std::string_view text, std::size_t width);
std::string padded(std::string_view text, std::size_t width);

/// Returns a number with its unit; "not known" for NaN.
std::string valued(double value, const std::string& unit);

/// Returns a bar that is filled by a share, 0 to 1.
std::string bar(double share, bool ascii);

/// Returns one character for each value, scaled from the lowest to the highest value. If there are
/// more than `width` values, only the last ones are shown.
std::string sparkline(const std::deque<double>& values, std::size_t width, bool ascii);

/// Returns one character for each class, with a logarithmic scale. With a linear scale, only the
/// most frequent class would be visible.
std::string histogram(const wire::Histogram& counts, bool ascii);

}  // namespace jounce::machine_detail
