// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "jounce/plot/figure.hpp"

namespace jounce {

/// A path in a plane, with the same scale on both axes. Its color shows the speed along the path.
struct PathFigure {
  /// A marked point with a text.
  struct Mark {
    double x = 0, y = 0;
    std::string text{};
  };

  std::string title{};
  std::string x_label{}, y_label{};  ///< labels of the axes, with their units: "x [mm]"
  std::string speed_label{};         ///< label of the color scale: "speed [mm/s]"
  std::vector<double> x{}, y{};  ///< points along the path: at least two, x and y of the same size
  /// Speed at each point, >= 0. The color between two points shows the mean of their speeds.
  std::vector<double> speed{};
  /// True for a point at which a rapid (a line without the tool) ends. Rapids are drawn thin and
  /// gray, and are cut at the frame of the other lines. Empty: no rapids. The speed of a rapid is
  /// not shown; it must not exceed the greatest speed of the other lines.
  std::vector<bool> rapid{};
  std::vector<Mark> marks{};  ///< marked points
};

/// Returns the figure as an SVG document, like svg() of a Figure. `options.panel_height` is not
/// used.
std::string svg(const PathFigure& figure, const SvgOptions& options = {});

}  // namespace jounce
