// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <utility>
#include <vector>

#include "jounce/cam/coupling/master_limits.hpp"
#include "jounce/gear/cutter.hpp"
#include "jounce/profiles/detail/tolerances.hpp"

// Bounds of the lengths of a cutter, for which its slave keeps its limits on a line.

namespace jounce::gear_detail {

/// Returns the greatest speed of the line for these segments, m/s.
inline double speed_of(std::vector<Segment> segments, const CutLine& line) {
  const Cam cam(std::move(segments));  // no rest outside: it begins and ends in motion
  return greatest_master_velocity(cam, line.slave, line.rates).value;
}

/// True if the slave keeps its limits on these segments, at the speed of the line.
inline bool permits(std::vector<Segment> segments, const CutLine& line) {
  return speed_of(std::move(segments), line) >= line.speed * (1 - profiles_detail::rounded_input);
}

/// Returns the segments with `length` times their length and `travel` times their positions.
inline std::vector<Segment> stretched(const std::vector<Segment>& segments, double length,
                                      double travel) {
  std::vector<Segment> all;
  for (const Segment& segment : segments) {
    all.push_back(scaled(segment, travel));
    all.back().length *= length;
  }
  return all;
}

/// Returns the length between `from` and `to` at which `can` changes, to 1e-13 of its value: the
/// end at which it is true.
template <class Can>
double change(double from, double to, Can&& can) {
  constexpr double resolution = 1e-13;
  const bool before = can(from);
  while (to - from > resolution * to) {
    const double middle = from + (to - from) / 2;
    if (middle == from || middle == to) break;
    (can(middle) == before ? from : to) = middle;
  }
  return before ? from : to;
}

/// Returns the least factor of a length, from 1 on, for which `holds` is true; infinite: none up to
/// 2^20. It remains true for greater factors.
template <class Holds>
double least_factor(Holds&& holds) {
  constexpr double most = 0x1p20;
  if (holds(1.0)) return 1;
  double factor = 2;
  while (!holds(factor))
    if (factor *= 2; factor > most) return std::numeric_limits<double>::infinity();
  return change(factor / 2, factor, holds);
}

}  // namespace jounce::gear_detail
