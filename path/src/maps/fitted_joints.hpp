// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "path/src/maps/joined.hpp"

namespace jounce {

/// The pieces of `path` divided until a polynomial of degree 7 for each joint is within the tolerance of the map, with
/// the joints behind the axes of the tool, and boxes that keep the limits of both. `path` is that of `tool`, rounded or
/// not. Throws InputError with the line where the tool is out of reach or the map is singular.
Jointed fitted_joints(Path path, Rounded tool, const JointSpace& joints, const Rates& rates,
                      const Program& program);

}  // namespace jounce
