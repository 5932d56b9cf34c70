// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "jounce/path/overlap.hpp"
#include "jounce/path/plan.hpp"
#include "jounce/profiles/sequences/override.hpp"

namespace jounce::path_proof {

/// One command, as data that a test can transform.
struct Leg {
  enum class Shape : std::uint8_t { line, arc, spline };

  Shape shape = Shape::line;
  Point to{};
  Point via{};                 ///< point on an arc
  std::vector<Point> through;  ///< points of a spline before `to`
  PathSettings settings;
  double dwell = 0;  ///< s, before the command
};

/// A program with its limits, as data. Leg i has the source line i + 1.
struct Case {
  std::size_t axes = 2;
  std::size_t path_axes = 2;
  Point start{};
  std::vector<Leg> legs;
  GroupLimits limits;

  [[nodiscard]] const Point& from(std::size_t leg) const {
    return leg == 0 ? start : legs[leg - 1].to;
  }
  /// Greatest coordinate of an axis.
  [[nodiscard]] double size(std::size_t axis) const;
  [[nodiscard]] bool has(Leg::Shape shape) const;
};

/// Writes a program; each line and each arc is divided into `parts`.
Program program_of(const Case& c, int parts = 1);

/// The arc of a leg.
Arc arc_of(const Case& c, std::size_t leg);

/// The case as a spec: `jounce check` plans the same program. `rest`: further lines of [path], or of the top level
/// after it, such as [[override]].
std::string spec_of(const Case& c, const std::string& in_path = {}, const std::string& rest = {});

/// The same motion with other points.
template <class Map>
Case mapped(Case c, Map map) {
  c.start = map(c.start);
  for (Leg& leg : c.legs) {
    leg.to = map(leg.to);
    leg.via = map(leg.via);
    for (Point& p : leg.through) p = map(p);
  }
  return c;
}

/// The same motion in other units of length and time.
Case scaled(Case c, double length, double time);

/// A number with 17 digits.
std::string text(double x);

}  // namespace jounce::path_proof
