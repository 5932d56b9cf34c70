// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "path/src/geometry/route.hpp"

namespace jounce {

/// The route with its runs of lines under Corner::average replaced by their averages
/// (docs/path/README.md, "Averages"). A run ends where two lines meet at more than `sharpest`, at a
/// rest, and where another corner mode begins. Returns nothing if no settings request averages.
std::optional<Route> with_averages(const Route& route, const Program& program);

/// |w - u| of two lines above which a corner is not averaged: 29 degrees. A single sharp corner
/// would make the window, and so all turns of the run, small.
inline constexpr double sharpest = 0.5;

}  // namespace jounce
