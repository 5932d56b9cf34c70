// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace jounce {

enum class Style {
  line,   ///< the curve itself
  under,  ///< a wide pale line beneath the others: what was before, what is compared with
  dots,   ///< the points alone: knots, measured values
};

/// One line of a plot. x and y are of equal size; a jump is two points at one x, and a point that
/// is not finite leaves a gap.
struct Series {
  std::string label{};  ///< for the legend, which appears where a figure has several labels
  std::vector<double> x{};
  std::vector<double> y{};
  Style style = Style::line;
};

/// A point that is worth a number beside it.
struct Marker {
  double x = 0;
  double y = 0;
  std::string text{};   ///< shown beside it if there is enough space
  std::string hint{};   ///< shown where a pointer rests on it; may be empty
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
/// if there is space; a pointer shows every name. A limit that is held by far is not drawn
/// but noted above its panel.
struct Figure {
  std::string title{};
  std::string x_label{};
  std::vector<Panel> panels{};
  std::vector<Shade> shades{};
  /// Rows of names above the plots: segments, their laws. Those of the first row are cut to their
  /// stretch, the others stand where they fit. A row of which nothing fits is left out; where there
  /// is a row, shades are not named a second time.
  std::vector<std::vector<Shade>> strips{};
  std::vector<double> knots{};  ///< thin vertical lines; left out, and so noted, where too dense
  bool degrees = false;         ///< x is an angle: ticks at 30, 45, 60, 90 deg, ...
  bool decades =
      false;  ///< x is a decimal logarithm: ticks at 1, 2, 5, 10, ... as the number itself
};

struct SvgOptions {
  double width = 860;         ///< px
  double panel_height = 120;  ///< px, of the plot proper
  bool inlined = false;       ///< for html(), which has the style sheet and sets the size
};

/// The figure as an SVG document of its own: plain text labels, no script, nothing loaded, light or
/// dark as its viewer prefers (light where it has no preference). Equal figures give equal bytes.
std::string svg(const Figure& figure, const SvgOptions& options = {});

}  // namespace jounce
