// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace jounce::base_detail {

/// True if the bytes begin with the byte order mark of UTF-16.
bool is_utf16(std::string_view bytes);
/// Returns text in UTF-16, which begins with its byte order mark, as UTF-8 without the mark. Throws
/// InputError for half a code unit and for a surrogate without its partner.
std::string from_utf16(std::string_view bytes);

}  // namespace jounce::base_detail
