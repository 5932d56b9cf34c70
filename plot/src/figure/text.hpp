// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace jounce {

/// Returns a text that is safe in elements and quoted attributes of XML and HTML: & < > " ' become
/// entities. Control characters and invalid UTF-8, which XML 1.0 does not permit, become U+FFFD.
std::string escaped(std::string_view text);

/// Returns an upper bound of the width of a text in any common sans-serif font of this size, px.
double text_width(std::string_view text, double font_size);

/// Returns the text; if it is wider than `width` px, it is cut and ends with an ellipsis.
std::string fitted(std::string_view text, double font_size, double width);

}  // namespace jounce
