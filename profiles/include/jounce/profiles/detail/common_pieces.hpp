// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

#include "jounce/profiles/curve/curve.hpp"
#include "jounce/profiles/detail/tolerances.hpp"

namespace jounce::profiles_detail {

/// True if two positions are equal except for rounding; `scale` is the magnitude of the positions.
inline bool same_place(double a, double b, double scale) {
  return std::abs(a - b) <= rounded_sum * scale;
}

/// Calls visit(start, f_part, i, g_part, k) for each stretch on which each of the two curves is a
/// single segment, within the interval that both share. f_part is the part of segment i of f,
/// g_part the part of segment k of g; both have the same length. Two breaks that differ only by
/// rounding count as one, at the break of f.
template <class Over, class Visit>
void for_common_pieces(const Curve<Over>& f, const Curve<Over>& g, Visit visit) {
  const double scale = std::max(std::abs(f.start()), std::abs(f.end()));
  const auto near = [scale](double a, double b) { return same_place(a, b, scale); };
  double x = near(f.start(), g.start()) ? f.start() : std::max(f.start(), g.start());
  const auto first = [&](const Curve<Over>& c) {
    std::size_t n = 0;
    // A segment that ends at x (within rounding) is over. If c begins at x, the end of its first
    // segment only lies near x because the segment is short.
    const auto over = [&](double end) { return end <= x || (x != c.start() && near(end, x)); };
    while (n < c.segments().size() && over(c.breaks()[n + 1])) ++n;
    return n;
  };
  std::size_t i = first(f);
  std::size_t k = first(g);
  while (i < f.segments().size() && k < g.segments().size()) {
    const double f_end = f.breaks()[i + 1];
    const double g_end = g.breaks()[k + 1];
    const bool both = near(f_end, g_end);
    const double next = both ? f_end : std::min(f_end, g_end);
    const bool f_ends = both || next == f_end;
    const bool g_ends = both || next == g_end;
    // A whole segment keeps its own length, because the difference of two positions has fewer
    // digits.
    const bool f_whole = f_ends && near(x, f.breaks()[i]);
    const bool g_whole = g_ends && near(x, g.breaks()[k]);
    const double length = f_whole   ? f.segments()[i].length
                          : g_whole ? g.segments()[k].length
                                    : next - x;
    const auto piece = [&](const Curve<Over>& c, std::size_t n, bool ends_here) {
      const Segment& whole = c.segments()[n];
      const double width = std::min(1.0, length / whole.length);
      const double s0 =
          ends_here ? 1 - width : std::clamp((x - c.breaks()[n]) / whole.length, 0.0, 1 - width);
      const double s1 = std::min(1.0, s0 + width);
      // If the other piece is shorter than the rounding of this one, this one is constant over it.
      Segment cut =
          s0 < s1 ? part(whole, s0, s1) : line(length, value(whole, s0), value(whole, s0));
      cut.length = length;
      return cut;
    };
    visit(x, piece(f, i, f_ends), i, piece(g, k, g_ends), k);
    i += f_ends ? 1 : 0;
    k += g_ends ? 1 : 0;
    x = next;
  }
}

}  // namespace jounce::profiles_detail
