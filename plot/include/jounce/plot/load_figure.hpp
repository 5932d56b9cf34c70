// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "jounce/design/input.hpp"
#include "jounce/plot/curve_figure.hpp"
#include "jounce/plot/figure.hpp"

namespace jounce {

/// Returns the panel with the torque of the motor over the master, from [load] and the velocity of
/// [master], over the pale torque of another cam. Friction and the sine of a lever are not drawn.
/// Empty for a spec without [load] or [master].
std::vector<Panel> torque_panels(const Spec& spec, const Cam& cam, const Cam& before,
                                 const CurveLook& look);

/// Returns the torque and the mechanical power of the motor, one panel each; nullopt for an input
/// without [load] or [master], or of a motion over time. Only the torque with friction or a lever.
std::optional<Figure> load_figure(const Input& input);

}  // namespace jounce
