// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "jounce/path/arc.hpp"
#include "jounce/path/program.hpp"
#include "jounce/path/shapes.hpp"

namespace jounce {

/// A constant frame: the position and orientation of a part in the machine (PCS in MCS; G54 to
/// G59).
///
///     machine = offset + rotation * part
///
/// The rotation applies to the first three axes of a group, the offset to all axes. A frame does
/// not change lengths, feeds and corners.
struct Frame {
  Point offset{};  ///< in the units of the axes
  /// Rows of the rotation matrix.
  std::array<std::array<double, 3>, 3> rotation{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};

  /// True if the frame has no rotation. Coordinates are then only shifted.
  [[nodiscard]] bool shifts() const;
  bool operator==(const Frame&) const = default;
};

/// Returns a frame that is rotated by an angle (deg) around the third axis, from the first axis
/// towards the second. Exact for multiples of 90 deg.
Frame turned_frame(const Point& offset, double degrees);
/// Returns a frame that is rotated around Z, then around the new Y, then around the new Z (PMC600
/// manual 7.1). Angles are in deg.
Frame euler_frame(const Point& offset, const std::array<double, 3>& zyz);

/// Returns the machine coordinates of a point of the part.
Point placed(const Frame& frame, const Point& part);
/// Returns the part coordinates of a point of the machine.
Point within(const Frame& frame, const Point& machine);
/// Return an arc, a curve or a program of the part in machine coordinates.
Arc placed(const Frame& frame, const Arc& arc);
PathCurve placed(const Frame& frame, const PathCurve& curve);
/// Throws InputError "rotation" if the frame rotates axes that are not path axes of the program.
Program placed(const Frame& frame, const Program& program);

}  // namespace jounce
