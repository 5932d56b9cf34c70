// SPDX-License-Identifier: Apache-2.0
#include "plot/src/figure/text.hpp"

#include <cstddef>

namespace jounce {
namespace {

unsigned byte_at(std::string_view text, std::size_t i) {
  return i < text.size() ? static_cast<unsigned char>(text[i]) : 0U;
}

/// Bytes of the well-formed character that `text` begins with, 0 if it is broken (RFC 3629: no
/// overlong forms, no surrogates, nothing above U+10FFFF).
std::size_t character_length(std::string_view text) {
  const unsigned lead = byte_at(text, 0);
  if (lead < 0x80) return 1;
  const std::size_t n = lead >= 0xC2 && lead <= 0xDF   ? 2
                        : lead >= 0xE0 && lead <= 0xEF ? 3
                        : lead >= 0xF0 && lead <= 0xF4 ? 4
                                                       : 0;
  for (std::size_t i = 1; i < n; ++i)
    if ((byte_at(text, i) & 0xC0U) != 0x80) return 0;
  const unsigned second = byte_at(text, 1);
  const bool overlong = (lead == 0xE0 && second < 0xA0) || (lead == 0xF0 && second < 0x90);
  const bool beyond = (lead == 0xED && second >= 0xA0) || (lead == 0xF4 && second >= 0x90);
  return overlong || beyond ? 0 : n;
}

/// U+FFFE and U+FFFF are no characters to XML 1.0.
bool is_noncharacter(std::string_view character) {
  return character == "\xEF\xBF\xBE" || character == "\xEF\xBF\xBF";
}

void append_escaped(std::string& out, std::string_view character) {
  const unsigned c = byte_at(character, 0);
  if (character == "&") {
    out += "&amp;";
  } else if (character == "<") {
    out += "&lt;";
  } else if (character == ">") {
    out += "&gt;";
  } else if (character == "\"") {
    out += "&quot;";
  } else if (character == "'") {
    out += "&#39;";
  } else if ((c < 0x20 && c != '\n' && c != '\t') || c == 0x7F || is_noncharacter(character)) {
    out += "\uFFFD";
  } else {
    out += character;
  }
}

/// Width of a character in units of the font size: no less than in Helvetica, Segoe, Roboto and
/// DejaVu Sans.
double advance(std::string_view character) {
  constexpr std::string_view narrow = "iljI.,:;|!'`()[]/ ftr";
  constexpr std::string_view wide = "mwMWQO%@";
  if (character.size() > 2) return character[0] == '\xE2' ? 0.75 : 1.0;  // − ⁻ ⁴ ..., or CJK
  if (narrow.find(character) != std::string_view::npos) return 0.4;
  if (wide.find(character) != std::string_view::npos) return 0.97;
  const bool capital = character.size() == 1 && character[0] >= 'A' && character[0] <= 'Z';
  return capital ? 0.72 : 0.64;
}

/// Calls use(character) for each character; a broken byte counts as U+FFFD.
template <class Use>
void for_each_character(std::string_view text, Use use) {
  while (!text.empty()) {
    const std::size_t n = character_length(text);
    use(n > 0 ? text.substr(0, n) : std::string_view("\uFFFD"));
    text.remove_prefix(n > 0 ? n : 1);
  }
}

}  // namespace

std::string escaped(std::string_view text) {
  std::string out;
  out.reserve(text.size());
  for_each_character(text, [&](std::string_view character) { append_escaped(out, character); });
  return out;
}

double text_width(std::string_view text, double font_size) {
  double width = 0;
  for_each_character(text, [&](std::string_view character) { width += advance(character); });
  return width * font_size;
}

std::string fitted(std::string_view text, double font_size, double width) {
  if (text_width(text, font_size) <= width) return std::string(text);
  std::string out;
  double left = width - text_width("…", font_size);
  bool full = false;
  for_each_character(text, [&](std::string_view character) {
    left -= advance(character) * font_size;
    full = full || left < 0;
    if (!full) out += character;
  });
  return out + "…";
}

}  // namespace jounce
