// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "optimize/src/program/shape_model.hpp"

/// Why the limits of a shape cannot be kept.
namespace jounce::optimizer {

/// True if no shape at all has what is fixed at the ends and kept exactly; looked for near `z`.
bool contradictory(const ShapeModel& model, const Coordinates& z);

/// Of walls that no free coordinate changes, what one is broken by, as a sentence. None where all are
/// kept, and where what is fixed contradicts itself.
std::optional<std::string> broken_where_fixed(const ShapeModel& model, const Coordinates& z);

/// The walls that stand in each other's way where `shape` has the least common violation, `slack`.
std::string worst_walls(const ShapeModel& model, const Coordinates& z, double slack);

}  // namespace jounce::optimizer
