// SPDX-License-Identifier: Apache-2.0
#include "plot/src/figure/path.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace jounce {
namespace {

constexpr double tolerance = 0.1;  // px
constexpr double columns_per_px = 2;

double distance(Pixel p, Pixel a, Pixel b) {
  const double dx = b.x - a.x;
  const double dy = b.y - a.y;
  const double length2 = dx * dx + dy * dy;
  const double along = length2 > 0 ? ((p.x - a.x) * dx + (p.y - a.y) * dy) / length2 : 0;
  const double t = std::clamp(along, 0.0, 1.0);
  return std::hypot(p.x - a.x - t * dx, p.y - a.y - t * dy);
}

/// Marks the points to keep between `first` and `last`, which are kept.
void keep_between(std::span<const Pixel> line, std::vector<bool>& keep) {
  std::vector<std::pair<std::size_t, std::size_t>> open{{0, line.size() - 1}};
  while (!open.empty()) {
    const auto [first, last] = open.back();
    open.pop_back();
    std::size_t farthest = first;
    double most = tolerance;
    for (std::size_t i = first + 1; i < last; ++i) {
      const double d = distance(line[i], line[first], line[last]);
      if (d > most) {
        most = d;
        farthest = i;
      }
    }
    if (farthest == first) continue;
    keep[farthest] = true;
    open.emplace_back(first, farthest);
    open.emplace_back(farthest, last);
  }
}

/// A whole number of hundredths, with a blank before it where the number before needs one.
void append_hundredths(std::string& out, long value, bool separate) {
  if (separate && value >= 0) out += ' ';
  if (value < 0) out += '-';
  const long magnitude = std::abs(value);
  const long fraction = magnitude % 100;
  if (magnitude >= 100 || fraction == 0) out += std::to_string(magnitude / 100);
  if (fraction == 0) return;
  out += '.';
  out += static_cast<char>('0' + fraction / 10);
  if (fraction % 10 != 0) out += static_cast<char>('0' + fraction % 10);
}

}  // namespace

std::vector<Pixel> aggregated(std::span<const Pixel> line) {
  std::vector<Pixel> out;
  const auto column = [&](std::size_t i) { return std::floor(line[i].x * columns_per_px); };
  for (std::size_t begin = 0, end = 0; begin < line.size(); begin = end) {
    while (end < line.size() && column(end) == column(begin)) ++end;
    const auto group = line.subspan(begin, end - begin);
    const auto [low, high] = std::minmax_element(
        group.begin(), group.end(), [](const Pixel& a, const Pixel& b) { return a.y < b.y; });
    const bool all = group.size() <= 4;
    for (auto it = group.begin(); it != group.end(); ++it) {
      if (all || it == group.begin() || it == low || it == high || it + 1 == group.end())
        out.push_back(*it);
    }
  }
  return out;
}

std::vector<Pixel> thinned(std::span<const Pixel> line) {
  auto candidates = aggregated(line);
  if (candidates.size() < 3) return candidates;
  std::vector<bool> keep(candidates.size(), false);
  keep.front() = keep.back() = true;
  keep_between(candidates, keep);
  std::vector<Pixel> out;
  for (std::size_t i = 0; i < candidates.size(); ++i)
    if (keep[i]) out.push_back(candidates[i]);
  return out;
}

std::string coordinate(double px) {
  std::string out;
  append_hundredths(out, std::lround(px * 100), false);
  return out;
}

std::string path_data(std::span<const Pixel> line) {
  std::string out;
  long x = 0;
  long y = 0;
  char command = 0;
  for (const Pixel& p : line) {
    const long to_x = std::lround(p.x * 100);
    const long to_y = std::lround(p.y * 100);
    const bool first = command == 0;
    const long dx = to_x - x;
    const long dy = to_y - y;
    if (!first && dx == 0 && dy == 0) continue;
    const char next = first ? 'M' : dx == 0 ? 'v' : dy == 0 ? 'h' : 'l';
    const bool repeated = next == command;
    if (!repeated) out += next;
    if (next != 'v') append_hundredths(out, dx, repeated);
    if (next != 'h') append_hundredths(out, dy, next != 'v' || repeated);
    command = next;
    x = to_x;
    y = to_y;
  }
  if (command == 'M') out += "h0";
  return out;
}

}  // namespace jounce
