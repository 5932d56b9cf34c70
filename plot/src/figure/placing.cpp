// SPDX-License-Identifier: Apache-2.0
#include "plot/src/figure/placing.hpp"

#include <algorithm>
#include <cstddef>
#include <limits>

namespace jounce {
namespace {

bool inside(const Rectangle& box, const Rectangle& frame) {
  return box.left >= frame.left && box.right <= frame.right && box.top >= frame.top &&
         box.bottom <= frame.bottom;
}

int crossings(const Rectangle& box, const std::vector<std::vector<Pixel>>& lines) {
  int count = 0;
  for (const auto& line : lines) {
    for (std::size_t i = 1; i < line.size(); ++i)
      if (crosses(box, line[i - 1], line[i])) ++count;
  }
  return count;
}

}  // namespace

bool overlap(const Rectangle& a, const Rectangle& b) {
  return a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;
}

// Liang and Barsky (1984): the part t0..t1 of the line that is left when each edge has cut it.
bool crosses(const Rectangle& box, Pixel from, Pixel to) {
  double t0 = 0;
  double t1 = 1;
  const auto cut = [&](double direction, double room) {
    if (direction == 0) return room >= 0;
    const double t = room / direction;
    (direction < 0 ? t0 : t1) = direction < 0 ? std::max(t0, t) : std::min(t1, t);
    return t0 <= t1;
  };
  const double dx = to.x - from.x;
  const double dy = to.y - from.y;
  return cut(-dx, from.x - box.left) && cut(dx, box.right - from.x) && cut(-dy, from.y - box.top) &&
         cut(dy, box.bottom - from.y);
}

std::optional<std::size_t> place(const Surroundings& around,
                                 std::span<const Rectangle> candidates) {
  std::optional<std::size_t> best;
  int fewest = std::numeric_limits<int>::max();
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    const Rectangle& box = candidates[i];
    const bool free = inside(box, around.frame) &&
                      std::none_of(around.taken.begin(), around.taken.end(),
                                   [&](const Rectangle& b) { return overlap(b, box); });
    const int count = free ? crossings(box, around.lines) : fewest;
    if (count >= fewest) continue;
    fewest = count;
    best = i;
  }
  return best;
}

}  // namespace jounce
