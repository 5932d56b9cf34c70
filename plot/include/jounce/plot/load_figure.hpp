// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "jounce/design/input.hpp"
#include "jounce/plot/figure.hpp"

namespace jounce {

/// Returns the torque and the mechanical power of the motor, one panel each; nullopt for an input
/// without [load] or [master], or of a motion over time. Only the torque with friction or a lever.
std::optional<Figure> load_figure(const Input& input);

}  // namespace jounce
