// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "jounce/design/input.hpp"
#include "jounce/plot/path_figure.hpp"

namespace jounce {

/// Returns the path in the plane of two of its axes, such as "x,y", colored by its speed. Marks
/// show the five places that cost most time, with their lines in the program. Throws InputError
/// (key "plane") if the axes have no path, if an axis does not exist, or if the two axes have
/// different units.
PathFigure path_figure(const std::vector<Input>& axes, const std::string& plane);

}  // namespace jounce
