// SPDX-License-Identifier: Apache-2.0
#include "stream/src/message/fields.hpp"

#include <limits>

#include "jounce/base/detail/printable.hpp"
#include "jounce/profiles/error.hpp"

namespace jounce::wire {
namespace {

/// The longest part of the text that fits, without a partial UTF-8 character at the end.
std::string_view shortened(std::string_view text, std::size_t size) {
  if (text.size() < size) return text;
  std::size_t end = size - 1;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U) --end;
  return text.substr(0, end);
}

}  // namespace

std::int32_t put_count(const char* key, std::uint32_t count) {
  if (count > static_cast<std::uint32_t>(std::numeric_limits<std::int32_t>::max()))
    throw InputError(key, std::to_string(count), "must fit 31 bits");
  return static_cast<std::int32_t>(count);
}

void put_text(std::string_view text, std::uint8_t* bytes, std::size_t size) {
  const std::string clean = printable(text);  // otherwise get_text() rejects the whole message
  constexpr std::string_view cut = "...";
  const bool is_cut = clean.size() >= size && size > cut.size();
  std::string fits(shortened(clean, is_cut ? size - cut.size() : size));
  if (is_cut) {  // after a word, unless it fills half of the field
    const std::size_t space = fits.rfind(' ');
    if (space != std::string::npos && space >= size / 2) fits.resize(space);
    fits += cut;
  }
  std::fill_n(bytes, size, std::uint8_t{0});
  std::copy(fits.begin(), fits.end(), bytes);
}

bool get_text(const std::uint8_t* bytes, std::size_t size, std::string& text) {
  const auto* const end = std::find(bytes, bytes + size, std::uint8_t{0});
  text.assign(bytes, end);
  return end != bytes + size &&
         std::all_of(end, bytes + size, [](std::uint8_t byte) { return byte == 0; }) &&
         is_printable(text);
}

void put_unit(const char* key, const std::string& unit, std::uint8_t* bytes) {
  if (unit.size() >= unit_bytes)
    throw InputError(key, unit, "must be shorter than " + std::to_string(unit_bytes) + " bytes");
  put_text(unit, bytes, unit_bytes);
  if (std::string back; !get_text(bytes, unit_bytes, back) || back != unit)
    throw InputError(key, unit, "must be UTF-8 without control characters");
}

}  // namespace jounce::wire
