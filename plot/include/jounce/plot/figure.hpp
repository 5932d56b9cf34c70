// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace jounce {

/// Appearance of a series.
enum class Style {
  line,   ///< a line
  under,  ///< a wide pale line below the other lines: a previous version, or a reference
  dots,   ///< points only: knots, measured values
};

/// One line of a plot. x and y must have the same size. Two points at the same x make a jump. A
/// point that is not finite makes a gap.
struct Series {
  std::string label{};  ///< label in the legend, which is shown if a figure has several labels
  std::vector<double> x{};
  std::vector<double> y{};
  Style style = Style::line;  ///< appearance
};

/// A marked point with a text.
struct Marker {
  double x = 0;
  double y = 0;
  std::string text{};   ///< shown next to the point if there is space
  std::string hint{};   ///< shown when the pointer is on the point; may be empty
  bool broken = false;  ///< true: the point is beyond a limit
  /// True: the text is the value y; it is shown in the scale of the axis.
  bool is_value = false;
  bool text_only = false;  ///< true: a series has this point, so the marker has no circle
};

/// One plot of a figure.
struct Panel {
  std::string y_label{};          ///< label of the y axis, with its unit: "velocity [mm/s]"
  std::vector<Series> series{};   ///< lines
  std::optional<double> lower{};  ///< lower limit: the area below is tinted
  std::optional<double> upper{};  ///< upper limit: the area above is tinted
  std::vector<Marker> markers{};  ///< marked points, the most important first
  double noise = 0;               ///< variations smaller than this are drawn as a flat line
};

/// A range of the x axis with a name, such as a sync zone of a cam.
struct Shade {
  double from = 0;      ///< start of the range
  double to = 0;        ///< end of the range
  std::string label{};  ///< name
};

/// Plots above one another, over one x axis.
///
///     Figure figure{.title = "feeder", .x_label = "time [s]"};
///     figure.panels.push_back({.y_label = "v [mm/s]", .series = {{"axis 1", time, velocity}}});
///     std::string file = svg(figure);
///
/// Labels may contain any text; "^2" is shown as "²". Names of shades and numbers of knots are
/// shown if there is space; the pointer shows all names. A limit with a large margin is not drawn;
/// a note above the panel states it.
struct Figure {
  std::string title{};          ///< title above the plots
  std::string x_label{};        ///< name and unit of the x axis
  std::string x_note{};         ///< text after the x label, which applies to the whole figure
  std::vector<Panel> panels{};  ///< the plots, from top to bottom
  std::vector<Shade> shades{};  ///< tinted ranges
  /// Rows of names above the plots, such as the segments and their laws. Names in the first row are
  /// shortened to the width of their range; in other rows, a name is shown only if it fits. A row
  /// in which no name fits is omitted. If there are rows, the names of shades are not shown.
  std::vector<std::vector<Shade>> strips{};
  /// Names of ranges beside the shades, in one row with the names of the shades; a name is shown only
  /// if it fits. The knots then have no numbers.
  std::vector<Shade> names{};
  /// Thin vertical lines. If they are too dense, a note replaces them.
  std::vector<double> knots{};
  bool degrees = false;  ///< true: x is an angle, with ticks at 30, 45, 60, 90 deg, ...
  /// True: x is a decimal logarithm, with ticks that show the numbers 1, 2, 5, 10, ...
  bool decades = false;
};

/// Options of a picture.
struct SvgOptions {
  double width = 860;         ///< width, px
  double panel_height = 120;  ///< height of each plot without its labels, px
  bool inlined = false;       ///< true: for html() (page.hpp); the page then contains the style
                              ///< sheet and sets the size
};

/// Returns the figure as an SVG document. Labels are text; the document has no script and loads
/// nothing. Colors are light or dark as the viewer prefers; without a preference they are light.
/// Equal figures give equal bytes.
std::string svg(const Figure& figure, const SvgOptions& options = {});

}  // namespace jounce
