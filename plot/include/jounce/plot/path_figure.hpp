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
  /// True for a point at which a line without the tool ends (a rapid): drawn thin and gray, and outside
  /// the frame where the other lines are not. Empty: no such line. Speeds on these lines are not
  /// shown: they are at most the greatest speed of the others.
  std::vector<bool> rapid{};
  std::vector<Mark> marks{};  ///< marked points
};

/// Returns the figure as an SVG document, like svg() of a Figure. `options.panel_height` is not
/// used.
std::string svg(const PathFigure& figure, const SvgOptions& options = {});

}  // namespace jounce
