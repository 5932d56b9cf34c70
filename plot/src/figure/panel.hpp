// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "jounce/plot/figure.hpp"

#include "plot/src/figure/placing.hpp"
#include "plot/src/figure/ticks.hpp"

namespace jounce {

/// Font sizes of the style sheet, px.
constexpr double small_font = 11;
constexpr double label_font = 12;
constexpr double title_font = 15;

/// A range of an axis, and the places where its ends are drawn, px.
struct Scale {
  PlotRange of;      ///< the range
  double at_lo = 0;  ///< place of its lower end, px
  double at_hi = 1;  ///< place of its upper end, px

  /// Returns the place of a value, px.
  double operator()(double value) const {
    return at_lo + (value - of.lo) / of.span() * (at_hi - at_lo);
  }
};

/// The y axis of a panel, and the notes above it.
struct PanelAxis {
  PlotRange extent;
  Ticks ticks;
  bool lower = false;              ///< true if the lower limit is drawn
  bool upper = false;              ///< true if the upper limit is drawn
  std::vector<std::string> notes;  ///< notes above the panel
};

PanelAxis panel_axis(const Panel& panel, double height);

/// Returns the labels of the figure's lines and dots. The index of a label determines its style.
std::vector<std::string> line_labels(const Figure& figure);
/// Returns the CSS class of a series.
std::string series_class(const Series& series, const std::vector<std::string>& labels);

/// Returns the knots that are drawn: those inside the axis; none if they are too dense.
std::vector<double> drawn_knots(const Figure& figure, const Scale& x);

/// The place of one panel in the figure.
struct PanelPlace {
  Rectangle plot;  ///< area of the plot
  Scale x;
  double shade_top = 0;  ///< upper end of the shades, px
};

void draw_panel(std::string& out, const Figure& figure, const Panel& panel, PanelAxis axis,
                const PanelPlace& at);

/// Returns a label with its factor: "label (×10³)". For the exponent 0, only the label.
std::string with_factor(const std::string& label, int exponent);

}  // namespace jounce
