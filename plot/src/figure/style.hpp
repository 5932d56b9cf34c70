// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace jounce {

/// Number of line styles (color and dashes together); further series begin again.
constexpr int line_styles = 4;

/// Returns the CSS rules for a separate SVG file: light, or dark if the viewer prefers it.
std::string figure_style();

/// Returns the same rules for figures in a page, with the colors of the page (color_variables).
std::string inlined_figure_style();

/// Returns the CSS variables of the light or the dark palette: "--ink:#1c1e21;...".
std::string color_variables(bool dark);

}  // namespace jounce
