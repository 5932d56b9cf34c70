// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "optimize/src/program/shape_model.hpp"

/// Reasons why the limits of a shape cannot be kept.
namespace jounce::optimizer {

/// True if no shape at all has the fixed values at the ends and on the exact corridors; the search starts at
/// `z`.
bool contradictory(const ShapeModel& model, const Coordinates& z);

/// A sentence on a constraint that is broken and that no free coordinate changes. None where all such
/// constraints hold, and where the fixed values contradict each other.
std::optional<std::string> broken_where_fixed(const ShapeModel& model, const Coordinates& z);

/// The constraints that conflict where `shape` has the least common violation, `slack`.
std::string worst_constraints(const ShapeModel& model, const Coordinates& z, double slack);

}  // namespace jounce::optimizer
