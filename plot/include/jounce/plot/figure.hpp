// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace jounce {

enum class Style {
  line,   ///< the curve itself
  under,  ///< a wide pale line beneath the others: the previous version, or a reference
  dots,   ///< the points alone: knots, measured values
};

/// One line of a plot. x and y are of equal size; a jump is two points at one x, and a point that
/// is not finite leaves a gap.
struct Series {
  std::string label{};  ///< for the legend, which appears if a figure has several labels
  std::vector<double> x{};
  std::vector<double> y{};
  Style style = Style::line;
};

/// A point with a number beside it.
struct Marker {
  double x = 0;
  double y = 0;
  std::string text{};   ///< shown beside it if there is enough space
  std::string hint{};   ///< shown when a pointer rests on it; may be empty
  bool broken = false;  ///< beyond a limit
};

/// One plot of the stack.
struct Panel {
  std::string y_label{};  ///< includes the unit: "velocity [mm/s]"
  std::vector<Series> series{};
  std::optional<double> lower{};  ///< the allowed band: beyond it the plot is tinted
  std::optional<double> upper{};
  std::vector<Marker> markers{};  ///< the most important first
  double noise = 0;               ///< a variation of no more than this is drawn as a flat line
};

/// A stretch of the x axis with a name, such as the synchronous one of a cam.
struct Shade {
  double from = 0;
  double to = 0;
  std::string label{};
};

/// Stacked plots over one x axis.
///
///     Figure figure{.title = "feeder", .x_label = "time [s]"};
///     figure.panels.push_back({.y_label = "v [mm/s]", .series = {{"axis 1", time, velocity}}});
///     std::string file = svg(figure);
///
/// Labels may hold any text; "^2" in them is shown as "²". A shade is named, and a knot numbered,
/// if there is space; a pointer shows every name. A limit with a large margin is not drawn but
/// noted above its panel.
struct Figure {
  std::string title{};
  std::string x_label{};
  std::vector<Panel> panels{};
  std::vector<Shade> shades{};
  /// Rows of names above the plots: segments, their laws. Those of the first row are cut to the
  /// width of their stretch, the others are shown if they fit. A row without a name that fits is
  /// omitted; if there is a row, shades are not named a second time.
  std::vector<std::vector<Shade>> strips{};
  std::vector<double> knots{};  ///< thin vertical lines; if too dense, omitted with a note
  bool degrees = false;         ///< x is an angle: ticks at 30, 45, 60, 90 deg, ...
  bool decades =
      false;  ///< x is a decimal logarithm: ticks at 1, 2, 5, 10, ... as the number itself
};

struct SvgOptions {
  double width = 860;         ///< px
  double panel_height = 120;  ///< px, of the plot proper
  bool inlined = false;       ///< for html(), which has the style sheet and sets the size
};

/// The figure as a separate SVG document: plain text labels, no script, nothing loaded, light or
/// dark as the viewer prefers (light without a preference). Equal figures give equal bytes.
std::string svg(const Figure& figure, const SvgOptions& options = {});

}  // namespace jounce
