// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace jounce {

/// Number of line styles (color and dashes together); further series begin again.
constexpr int line_styles = 4;

/// The rules for a separate SVG file: light, or dark where the viewer prefers it.
std::string figure_style();

/// The same rules for figures in a page, in the page's colours (see colour_variables).
std::string inlined_figure_style();

/// The CSS variables of the light and the dark palette: "--ink:#1c1e21;...".
std::string colour_variables(bool dark);

}  // namespace jounce
