// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "jounce/design/input.hpp"
#include "jounce/plot/path_figure.hpp"

namespace jounce {

/// A path in the plane of two of its axes ("x,y"), colored by the speed of its path axes; the five places that cost
/// most time are marked with their lines. Throws InputError (key "plane"): no path, other axes, two units.
PathFigure path_figure(const std::vector<Input>& axes, const std::string& plane);

}  // namespace jounce
