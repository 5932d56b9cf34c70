// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "jounce/path/arc.hpp"
#include "jounce/path/program.hpp"
#include "jounce/path/shapes.hpp"

namespace jounce {

/// A constant frame: the pose of a part in the machine (PCS in MCS; G54 ... G59).
///
///     machine = offset + rotation * part
///
/// The rotation acts on the first three axes of a group, the offset on all. Lengths, feeds and corners stay as they
/// are.
struct Frame {
  Point offset{};
  std::array<std::array<double, 3>, 3> rotation{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};  ///< rows

  /// True without a rotation: positions then are sums, to the last digit.
  [[nodiscard]] bool shifts() const;
  bool operator==(const Frame&) const = default;
};

/// Turned by an angle about the third axis, from the first axis towards the second. Exact for multiples of 90 deg.
Frame turned_frame(const Point& offset, double degrees);
/// Turned about Z, then about the new Y, then about the new Z (PMC600 manual 7.1), deg.
Frame euler_frame(const Point& offset, const std::array<double, 3>& zyz);

Point placed(const Frame& frame, const Point& part);
/// The part's coordinates of a point of the machine.
Point within(const Frame& frame, const Point& machine);
Arc placed(const Frame& frame, const Arc& arc);
PathCurve placed(const Frame& frame, const PathCurve& curve);
/// A whole program. Throws InputError "rotation" for a rotation of axes that are not path axes.
Program placed(const Frame& frame, const Program& program);

}  // namespace jounce
