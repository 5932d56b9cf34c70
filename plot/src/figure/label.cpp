// SPDX-License-Identifier: Apache-2.0
#include "jounce/plot/label.hpp"

#include <array>
#include <cctype>
#include <cmath>

#include <fmt/format.h>

namespace jounce {
namespace {

constexpr std::array raised{"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

/// Length of the integer that `text` begins with, sign included; 0 if there is none.
std::size_t integer_length(std::string_view text) {
  const std::size_t sign = !text.empty() && text[0] == '-' ? 1 : 0;
  std::size_t n = sign;
  while (n < text.size() && is_digit(text[n])) ++n;
  return n > sign ? n : 0;
}

std::string raise(std::string_view integer) {
  std::string out;
  for (const char c : integer) out += c == '-' ? "⁻" : raised[static_cast<std::size_t>(c - '0')];
  return out;
}

bool carries_power(char before) {
  return before == ')' || std::isalnum(static_cast<unsigned char>(before)) != 0 ||
         static_cast<unsigned char>(before) >= 0x80;  // the end of °, µ, Ω
}

}  // namespace

std::string superscripts(std::string_view text) {
  std::string out;
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t n = text[i] == '^' && i > 0 && carries_power(text[i - 1])
                              ? integer_length(text.substr(i + 1))
                              : 0;
    if (n > 0) {
      out += raise(text.substr(i + 1, n));
    } else {
      out += text[i];
    }
    i += 1 + n;
  }
  return out;
}

std::string short_number(double value, int digits) {
  if (std::isnan(value)) return "not a number";
  if (std::isinf(value)) return value > 0 ? "∞" : "−∞";
  const std::string text = fmt::format("{:.{}g}", std::abs(value), digits);
  const std::size_t e = text.find('e');
  std::string out = std::signbit(value) && text != "0" ? "−" : "";
  if (e == std::string::npos) return out + text;
  const std::string mantissa = text.substr(0, e);
  if (mantissa != "1") out += mantissa + "×";
  return out + "10" + raise(std::to_string(std::stoi(text.substr(e + 1))));
}

}  // namespace jounce
