// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace jounce {

/// Text made safe for XML and HTML, in elements and in quoted attributes alike: & < > " ' become
/// entities; control characters and broken UTF-8, which XML 1.0 cannot hold, become U+FFFD.
std::string escaped(std::string_view text);

/// Greatest width of the text in px, in any common sans-serif font of this size.
double text_width(std::string_view text, double font_size);

/// The text, cut with an ellipsis if it would be wider than `width` px.
std::string fitted(std::string_view text, double font_size, double width);

}  // namespace jounce
