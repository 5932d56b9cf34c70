// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "jounce/plot/figure.hpp"

namespace jounce {

/// A path in a plane, colored by the speed along it, at one scale for both axes.
struct PathFigure {
  struct Mark {
    double x = 0, y = 0;
    std::string text{};
  };

  std::string title{};
  std::string x_label{}, y_label{};  ///< include the unit: "x [mm]"
  std::string speed_label{};         ///< label of the scale of colors: "speed [mm/s]"
  std::vector<double> x{}, y{};      ///< points along the path, of equal size, at least two
  std::vector<double> speed{};       ///< >= 0, at each point; the line between two has the mean
  std::vector<Mark> marks{};
};

/// The figure as an SVG document, as svg() of a Figure; `width` counts, `panel_height` does not.
std::string svg(const PathFigure& figure, const SvgOptions& options = {});

}  // namespace jounce
