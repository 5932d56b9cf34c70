// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "jounce/design/input.hpp"
#include "jounce/plot/figure.hpp"

namespace jounce {

/// Returns the torque and the mechanical power of the motor, one panel each; nullopt for an input
/// without [load] or [master], or of a motion over time. If the load has dry friction or a lever,
/// returns only the torque, and only its linear part (torque_of() in shape_spec.hpp).
std::optional<Figure> load_figure(const Input& input);

}  // namespace jounce
