// SPDX-License-Identifier: Apache-2.0
#include "machine/src/operate/dashboard_text.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

namespace jounce::machine_detail {
namespace {

constexpr std::size_t bar_width = 20;

bool continues(char c) {
  return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U;
}

constexpr std::array<const char*, 9> blocks{" ", "▁", "▂", "▃", "▄", "▅", "▆", "▇", "█"};
constexpr std::array<const char*, 9> marks{" ", ".", ":", "-", "=", "+", "*", "#", "@"};

/// A column that is filled by a share of 0 to 1.
const char* column(double share, bool ascii) {
  const auto level = static_cast<std::size_t>(std::lround(std::clamp(share, 0.0, 1.0) * 8));
  return (ascii ? marks : blocks)[level];
}

}  // namespace

std::size_t columns(std::string_view text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return !continues(c); }));
}

std::string harmless(std::string_view text, bool ascii) {
  std::string out;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto c = static_cast<unsigned char>(text[i]);
    if (c < 0x80U) {
      out += c < 0x20U || c == 0x7FU ? '?' : text[i];
      continue;
    }
    std::size_t end = i + 1;
    while (end < text.size() && continues(text[end])) ++end;
    const bool control =
        c == 0xC2U && end == i + 2 && static_cast<unsigned char>(text[i + 1]) < 0xA0U;
    if (ascii || control || continues(text[i]))
      out += '?';
    else
      out += text.substr(i, end - i);
    i = end - 1;
  }
  return out;
}

std::string cut(std::string_view text, std::size_t width) {
  std::size_t end = 0;
  for (std::size_t column = 0; end < text.size() && column < width; ++column) {
    ++end;
    while (end < text.size() && continues(text[end])) ++end;
  }
  return std::string(text.substr(0, end));
}

std::string padded(std::string_view text, std::size_t width) {
  std::string out = cut(text, width);
  out.append(width - columns(out), ' ');
  return out;
}

std::string valued(double value, const std::string& unit) {
  return std::isnan(value) ? "not known" : fmt::format("{:.6g} {}", value, unit);
}

std::string bar(double share, bool ascii) {
  const auto full = static_cast<std::size_t>(
      std::lround(std::clamp(share, 0.0, 1.0) * static_cast<double>(bar_width)));
  std::string text;
  for (std::size_t i = 0; i < bar_width; ++i)
    text += i < full ? (ascii ? "#" : "█") : (ascii ? "." : "░");
  return text;
}

std::string histogram(const wire::Histogram& counts, bool ascii) {
  const double most = std::log1p(*std::max_element(counts.begin(), counts.end()));
  std::string text;
  for (const std::int32_t n : counts) {
    // One cycle among millions is seen too.
    const double share = n <= 0 ? 0 : std::max(1.0 / 8, std::log1p(n) / most);
    text += column(share, ascii);
  }
  return text;
}

std::string sparkline(const std::deque<double>& values, std::size_t width, bool ascii) {
  const std::size_t from = values.size() > width ? values.size() - width : 0;
  const auto begin = values.begin() + static_cast<std::ptrdiff_t>(from);
  if (begin == values.end()) return "";
  const auto [low, high] = std::minmax_element(begin, values.end());
  const double least = *low;
  const double range = *high - least;
  std::string text;
  // The lowest one is a line too: an axis that rests is there.
  for (auto v = begin; v != values.end(); ++v)
    text += column(range > 0 ? 1.0 / 8 + 7.0 / 8 * (*v - least) / range : 1.0 / 8, ascii);
  return text;
}

}  // namespace jounce::machine_detail
