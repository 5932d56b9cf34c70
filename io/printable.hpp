#pragma once

#include <string>
#include <string_view>

namespace jounce {

/// The text with `?` for every control character and every byte that is no UTF-8: what may be
/// printed to a terminal and written into the head of a file.
std::string printable(std::string_view text);

}  // namespace jounce
