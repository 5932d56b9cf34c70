// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "jounce/plot/figure.hpp"

#include "plot/src/figure/placing.hpp"
#include "plot/src/figure/ticks.hpp"

namespace jounce {

/// Font sizes, px: as the style sheet has them.
constexpr double small_font = 11;
constexpr double label_font = 12;
constexpr double title_font = 15;

/// A stretch of an axis and where its ends are drawn, px.
struct Scale {
  PlotRange of;
  double at_lo = 0;
  double at_hi = 1;

  double operator()(double value) const {
    return at_lo + (value - of.lo) / of.span() * (at_hi - at_lo);
  }
};

/// The y axis of a panel, and the text above it.
struct PanelAxis {
  PlotRange extent;
  Ticks ticks;
  bool lower = false;  ///< true if the limit is drawn
  bool upper = false;
  std::vector<std::string> notes;
};

PanelAxis panel_axis(const Panel& panel, double height);

/// The labels of the figure's lines and dots: a label's place here decides how it is drawn.
std::vector<std::string> line_labels(const Figure& figure);
std::string series_class(const Series& series, const std::vector<std::string>& labels);

/// The knots that are drawn: those inside the axis; none if they are too dense.
std::vector<double> drawn_knots(const Figure& figure, const Scale& x);

/// The place of one panel: the plot, and how far above it shades reach.
struct PanelPlace {
  Box plot;
  Scale x;
  double shade_top = 0;
};

void draw_panel(std::string& out, const Figure& figure, const Panel& panel, PanelAxis axis,
                const PanelPlace& at);

/// "(×10³)" after a label, or nothing.
std::string with_factor(const std::string& label, int exponent);

}  // namespace jounce
