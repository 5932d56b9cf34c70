// SPDX-License-Identifier: Apache-2.0
#include "jounce/base/detail/printable.hpp"

#include <cstdint>

namespace jounce {
namespace {

/// First character of a text: its length in bytes; 0: no character begins here.
struct Character {
  std::size_t length = 0;
  std::uint32_t code = 0;
};

/// The length that the first byte announces, and its own bits of the code.
Character announced(unsigned char first) {
  if (first < 0x80) return {1, first};
  if (first >= 0xC2 && first < 0xE0) return {2, first & 0x1FU};
  if (first >= 0xE0 && first < 0xF0) return {3, first & 0x0FU};
  if (first >= 0xF0 && first < 0xF5) return {4, first & 0x07U};
  return {};
}

/// RFC 3629, section 4.
Character first_of(std::string_view text) {
  Character c = announced(static_cast<unsigned char>(text[0]));
  if (c.length > text.size()) return {};
  for (std::size_t i = 1; i < c.length; ++i) {
    const auto byte = static_cast<unsigned char>(text[i]);
    if ((byte & 0xC0U) != 0x80U) return {};
    c.code = c.code << 6U | (byte & 0x3FU);
  }
  const bool overlong = (c.length == 3 && c.code < 0x800) || (c.length == 4 && c.code < 0x10000);
  const bool surrogate = c.code >= 0xD800 && c.code <= 0xDFFF;
  return overlong || surrogate || c.code > 0x10FFFF ? Character{} : c;
}

bool is_control(std::uint32_t code) {
  const bool turns = code == 0x061C || code == 0x200E || code == 0x200F ||
                     (code >= 0x202A && code <= 0x202E) || (code >= 0x2066 && code <= 0x2069);
  return code < 0x20 || (code >= 0x7F && code < 0xA0) || code == 0x2028 || code == 0x2029 || turns;
}

std::string shown(std::string_view text, std::string_view kept) {
  std::string out;
  while (!text.empty()) {
    const Character c = first_of(text);
    const bool keep = c.length > 0 && (!is_control(c.code) || kept.find(text[0]) != kept.npos);
    if (keep)
      out += text.substr(0, c.length);
    else
      out += '?';
    text.remove_prefix(c.length == 0 ? 1 : c.length);
  }
  return out;
}

}  // namespace

bool is_printable(std::string_view text) {
  while (!text.empty()) {
    const Character c = first_of(text);
    if (c.length == 0 || is_control(c.code)) return false;
    text.remove_prefix(c.length);
  }
  return true;
}

std::string printable(std::string_view text) {
  return shown(text, {});
}

std::string printable_lines(std::string_view text) {
  return shown(text, "\n\t");
}

}  // namespace jounce
