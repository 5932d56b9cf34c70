// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace jounce {

/// True if a text may be shown anywhere: UTF-8 (RFC 3629: no overlong form, no surrogate) without
/// control characters. Those are U+0000 to U+001F, U+007F to U+009F (a terminal obeys both), the
/// separators of lines and paragraphs, and the marks that change the direction of the text (U+061C,
/// U+200E, U+200F, U+202A to U+202E, U+2066 to U+2069), which can make one text look like another.
bool is_printable(std::string_view text);

/// The text with `?` for every such character and every byte that is not UTF-8: safe for a terminal
/// and for the head of a file. A text that is_printable() is returned as it is.
std::string printable(std::string_view text);

/// The same, but lines and tabs remain: for a message of several lines.
std::string printable_lines(std::string_view text);

}  // namespace jounce
