// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <span>
#include <vector>

namespace jounce {

/// A point of a path in a plane: the time, the place and the speed along the path.
struct DrawnPoint {
  double time = 0;
  double x = 0, y = 0;
  double speed = 0;
};

/// Returns points of a path from which straight lines draw it: at the instants `breaks`
/// (ascending), and between them as many as its curvature and its speed require. A line differs
/// from the path by at most 1e-4 of the size of the path, checked at three places of the line. The
/// speed changes by at most 1/32 of the greatest speed from point to point, or the points are
/// closer than 4e-4 of the size.
std::vector<DrawnPoint> path_points(std::span<const double> breaks,
                                    const std::function<DrawnPoint(double)>& at);

}  // namespace jounce
