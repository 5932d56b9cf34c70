// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace jounce {

/// True if a text is safe to show: valid UTF-8 (RFC 3629: no overlong form, no surrogate) without
/// these characters:
/// - control characters, which a terminal may obey: U+0000 to U+001F, U+007F to U+009F;
/// - separators of lines and paragraphs;
/// - marks that change the direction of the text and can make one text look like another: U+061C,
///   U+200E, U+200F, U+202A to U+202E, U+2066 to U+2069.
bool is_printable(std::string_view text);

/// Returns the text with `?` in place of each unsafe character and of each byte that is not valid
/// UTF-8. The result is safe for a terminal and for the head of a file. A printable text is
/// returned unchanged.
std::string printable(std::string_view text);

/// Like printable(), but keeps line feeds and tabs: for a message of several lines.
std::string printable_lines(std::string_view text);

}  // namespace jounce
