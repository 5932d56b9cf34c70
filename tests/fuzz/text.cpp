// SPDX-License-Identifier: Apache-2.0
#include "jounce/base/detail/printable.hpp"

#include "fuzz/fuzz.hpp"
#include "support/utf8.hpp"

namespace jounce::fuzz {
void text(Input input) {
  using test::is_utf8;
  const std::string given = text_of(input);
  const std::string shown = printable(given);
  require(is_printable(shown) && is_utf8(shown), "what is shown is printable");
  require((shown == given) == is_printable(given), "a printable text is shown as it is");
  require(!is_printable(given) || is_utf8(given), "a printable text is UTF-8");
  for (const char c : printable_lines(given))
    require(static_cast<unsigned char>(c) >= 0x20 || c == '\n' || c == '\t',
            "lines and tabs alone remain");
}

}  // namespace jounce::fuzz
