// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "jounce/plot/path_figure.hpp"

#include "cli/common/input.hpp"

namespace jounce::cli {

/// A path in the plane of two of its axes ("x,y"), colored by the speed of its path axes; the five places that cost
/// most time are marked with their lines. Throws InputError for --plane: no path, other axes, two units.
PathFigure path_figure(const std::vector<Input>& axes, const std::string& plane);

}  // namespace jounce::cli
