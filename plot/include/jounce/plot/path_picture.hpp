// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "jounce/design/input.hpp"
#include "jounce/plot/path_figure.hpp"

namespace jounce {

/// Returns the path in the plane of two of its axes, such as "x,y", colored by its speed. Marks
/// show the five places that cost most time, with their lines in the program. There are as many
/// points as the curvature and the speed require: a line between two points differs from the path
/// by at most 1e-4 of its size. Throws InputError (key "plane") if the axes have no path, if an
/// axis does not exist, or if the two axes have different units.
PathFigure path_figure(const std::vector<Input>& axes, const std::string& plane);

/// Returns the path to which an axis belongs, in the plane of the first two axes of the path, with
/// points like those of path_figure() above. Returns nullopt for an axis without a path, and for a
/// path of one axis.
std::optional<PathFigure> path_figure(const Input& axis);

}  // namespace jounce
