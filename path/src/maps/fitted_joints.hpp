// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "path/src/maps/joined.hpp"

namespace jounce {

/// Divides the pieces of `path` until a polynomial of degree 7 for each joint is within the
/// tolerance of the map. The joints follow the axes of the tool, and the boxes contain the limits
/// of both. `path` is the path of `tool`, rounded or not. Throws InputError with the source line if
/// the tool is out of reach or the map is singular.
Jointed fitted_joints(Path path, Rounded tool, const JointSpace& joints, const Rates& rates,
                      const Program& program);

}  // namespace jounce
