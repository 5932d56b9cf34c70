// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "jounce/design/input.hpp"

#include "plot/src/figure/curve_figure.hpp"

namespace jounce {

/// Returns the panel with the torque of the motor over the master, from [load] and the velocity of
/// [master], over the pale torque of another cam. Friction and the sine of a lever are not drawn.
/// Empty for a spec without [load] or [master].
std::vector<Panel> torque_panels(const Spec& spec, const Cam& cam, const Cam& before,
                                 const CurveLook& look);

}  // namespace jounce
