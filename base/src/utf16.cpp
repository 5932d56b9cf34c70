// SPDX-License-Identifier: Apache-2.0
#include "base/src/utf16.hpp"

#include <cstdint>

#include "jounce/profiles/error.hpp"

namespace jounce::base_detail {
namespace {

constexpr std::string_view little_endian = "\xFF\xFE";
constexpr std::string_view big_endian = "\xFE\xFF";

// Ranges of the Unicode standard, 3.8 and table 3-6.
constexpr std::uint32_t first_surrogate = 0xD800;
constexpr std::uint32_t second_surrogates = 0xDC00;
constexpr std::uint32_t after_surrogates = 0xE000;
constexpr std::uint32_t first_supplementary = 0x10000;

void append_utf8(std::string& text, std::uint32_t code) {
  const auto add = [&](std::uint32_t byte) { text += static_cast<char>(byte); };
  const auto rest = [&](unsigned shift) { add(0x80U | ((code >> shift) & 0x3FU)); };
  if (code < 0x80) {
    add(code);
  } else if (code < 0x800) {
    add(0xC0U | (code >> 6U)), rest(0);
  } else if (code < first_supplementary) {
    add(0xE0U | (code >> 12U)), rest(6), rest(0);
  } else {
    add(0xF0U | (code >> 18U)), rest(12), rest(6), rest(0);
  }
}

}  // namespace

bool is_utf16(std::string_view bytes) {
  return bytes.starts_with(little_endian) || bytes.starts_with(big_endian);
}

std::string from_utf16(std::string_view bytes) {
  const bool little = bytes.starts_with(little_endian);
  const auto fail = [](std::size_t at, const char* what) {
    throw InputError("", "",
                     "is text in UTF-16 with " + std::string(what) + " at byte " +
                         std::to_string(at + 1) +
                         ": save it again as UTF-8 (spreadsheets: CSV UTF-8)");
  };
  if (bytes.size() % 2 != 0) fail(bytes.size() - 1, "half a character");
  const auto unit = [&](std::size_t at) {
    const auto a = static_cast<std::uint8_t>(bytes[at]);
    const auto b = static_cast<std::uint8_t>(bytes[at + 1]);
    return little ? a | std::uint32_t{b} << 8U : b | std::uint32_t{a} << 8U;
  };
  std::string text;
  text.reserve(bytes.size() / 2);
  for (std::size_t at = 2; at < bytes.size(); at += 2) {
    std::uint32_t code = unit(at);
    if (code >= first_surrogate && code < after_surrogates) {
      const std::uint32_t second = at + 2 < bytes.size() ? unit(at + 2) : 0;
      if (code >= second_surrogates || second < second_surrogates || second >= after_surrogates)
        fail(at, "half a surrogate pair");
      code = first_supplementary + ((code - first_surrogate) << 10U) + (second - second_surrogates);
      at += 2;
    }
    append_utf8(text, code);
  }
  return text;
}

}  // namespace jounce::base_detail
