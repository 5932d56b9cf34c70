// SPDX-License-Identifier: Apache-2.0
#include "jounce/profiles/error.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <utility>

#include "jounce/profiles/detail/digits_beside.hpp"
#include "jounce/profiles/detail/six_digits.hpp"
#include "jounce/profiles/detail/tolerances.hpp"

namespace jounce {

std::string number(double value) {
  char text[32];
  // A whole number beyond 1e15, written with all digits, would be an integer in TOML, and too large
  // for one.
  const auto end = std::abs(value) < 1e15 ? std::to_chars(text, text + sizeof text, value)
                                          : std::to_chars(text, text + sizeof text, value,
                                                          std::chars_format::scientific);
  return {text, end.ptr};
}

namespace {

using profiles_detail::rounded_sum;
/// The number with this number of significant digits; its exponent has no plus sign and no leading
/// zeros.
std::string rounded(double value, int digits) {
  char text[40];
  const auto end =
      std::to_chars(text, text + sizeof text, value, std::chars_format::general, digits);
  std::string all(text, end.ptr);
  const std::size_t e = all.find('e');
  if (e == std::string::npos) return all;
  std::size_t sign = e + 1;
  if (all[sign] == '+')
    all.erase(sign, 1);
  else if (all[sign] == '-')
    ++sign;
  while (all[sign] == '0' && sign + 1 < all.size()) all.erase(sign, 1);
  return all;
}

/// The text without a possible secret: a run of as many hexadecimal digits as a key has.
std::string without_keys(const std::string& text) {
  constexpr std::size_t digits = 64;  // a key from `jounce new key`
  std::string shown;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end =
        std::min(text.find_first_not_of("0123456789abcdefABCDEF", at), text.size());
    const std::size_t run = end - at;
    if (run == digits)
      shown += "(" + std::to_string(run) + " hexadecimal digits, not shown)";
    else
      shown += text.substr(at, run);
    if (end < text.size()) shown += text[end];
    at = end + 1;
  }
  return shown;
}

/// The text; only its beginning if it is too long to read.
std::string shortened(const std::string& text) {
  constexpr std::size_t most = 200;
  constexpr std::size_t kept = 60;
  if (text.size() <= most) return text;
  std::size_t cut = kept;
  while (cut > 0 && (static_cast<unsigned char>(text[cut]) & 0xC0U) == 0x80U) --cut;  // UTF-8
  return text.substr(0, cut) + "... (" + std::to_string(text.size()) + " bytes)";
}

}  // namespace

std::string six_digits(double value) {
  const bool whole = std::abs(value) < 1e9 && value == std::trunc(value);
  return rounded(value, whole ? 9 : 6);
}

std::string six_digits_up(double value) {
  const std::string text = six_digits(value);
  double shown = 0;
  std::from_chars(text.data(), text.data() + text.size(), shown);
  const double rounding = rounded_sum * std::abs(value);  // the rounding of its computation
  if (!std::isfinite(value) || shown >= value - rounding) return text;
  return six_digits(shown + std::pow(10, std::floor(std::log10(std::abs(value))) - 5));
}

std::string six_digits_down(double value) {
  const std::string text = six_digits_up(-value);
  return text.starts_with('-') ? text.substr(1) : value == 0 ? "0" : '-' + text;
}

std::string digits_beside(double value, const std::string& other) {
  constexpr int most = 17;  // a double has no more
  std::string text = six_digits(value);
  for (int digits = 7; text == other && digits <= most; ++digits) text = rounded(value, digits);
  return text;
}

InputError::InputError(std::string key, std::string value, std::string rule)
    : key_(std::move(key)), value_(std::move(value)), rule_(std::move(rule)) {
  if (key_ != "sha256")  // a hash is no secret
    for (std::string* part : {&key_, &value_, &rule_}) *part = without_keys(*part);
  compose();
}

InputError::InputError(std::string key, double value, std::string rule)
    : InputError(std::move(key), rounded(value, 15), std::move(rule)) {}

InputError InputError::at(std::string document, int line, int column) const {
  InputError placed = *this;
  placed.document_ = std::move(document);
  placed.line_ = line;
  placed.column_ = column;
  placed.compose();
  return placed;
}

void InputError::compose() {
  const bool bare = document_.empty();
  text_ = document_;
  if (line_ > 0) text_ += (bare ? "line " : ":") + std::to_string(line_);
  if (line_ > 0 && column_ > 0) text_ += (bare ? ", column " : ":") + std::to_string(column_);
  if (!text_.empty()) text_ += ": ";
  if (!key_.empty()) text_ += key_ + (value_.empty() ? ": " : " = " + shortened(value_) + ": ");
  text_ += rule_;
}

void require_finite(const char* key, double value) {
  if (!std::isfinite(value)) throw InputError(key, value, "must be a finite number");
}

void require_positive(const char* key, double value) {
  require_finite(key, value);
  if (!(value > 0)) throw InputError(key, value, "must be greater than 0");
}

void require_not_negative(const char* key, double value) {
  require_finite(key, value);
  if (value < 0) throw InputError(key, value, "must not be negative");
}

void require_size(const char* key, std::size_t size, std::size_t expected) {
  if (size != expected)
    throw InputError(key, std::to_string(size) + " entries",
                     "must have " + std::to_string(expected));
}

}  // namespace jounce
