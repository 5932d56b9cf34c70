// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <vector>

namespace jounce {

/// A place in a drawing, in px, y downwards.
struct Pixel {
  double x = 0;
  double y = 0;
};

/// Returns the line with fewer points, nowhere farther than 0.1 px from the given one. If many
/// points are in the same half pixel column, only the first, last, lowest and highest are kept,
/// which draws the same pixels (M4: Jugel et al., "M4: A Visualization-Oriented Time Series Data
/// Aggregation", 2014). Then points on the line between others are removed (Douglas and Peucker,
/// 1973).
std::vector<Pixel> thinned(std::span<const Pixel> line);

/// Returns the result of the first step of thinned().
std::vector<Pixel> aggregated(std::span<const Pixel> line);

/// Returns a coordinate with two decimals, as short as possible: "12.5", "-.25", "0".
std::string coordinate(double px);

/// Returns SVG path data of the line: relative, with two decimals, without accumulating rounding. A
/// single point becomes a line of length 0, which round line caps draw as a dot.
std::string path_data(std::span<const Pixel> line);

}  // namespace jounce
