// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "jounce/io/points.hpp"
#include "jounce/spec/spec.hpp"

namespace jounce {

/// A cam as a drawing shows it.
struct DrawnCam {
  Points points = {};                 ///< columns `master` and `slave`, with their units
  std::optional<DiscPart> disc = {};  ///< for a plate: its follower and its base radius
};

/// Reads a cam from a drawing (drawing.hpp). A closed curve is a plate: the points are the motion
/// of its follower. An open curve is the graph of the slave (y) over the master (x).
///
/// `keys`: the keys of the table `drawing` of a spec, such as "roller_radius = 8, offset = 3".
/// `units`: units of the points; "": deg and mm for a plate, and the unit of the drawing for a
/// graph.
///
/// Throws InputError as read_outline() and plate_motion() do, and for a graph whose master runs
/// back. The error for a wrong key in `keys` has the key "drawing".
DrawnCam read_drawn_cam(const std::string& path, const std::string& keys, const Units& units);

}  // namespace jounce
