// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "optimize/src/program/shape_model.hpp"

/// The reason why no shape satisfies its limits.
namespace jounce::optimize_detail {

/// Residual of an equality, or of a constraint that nothing changes, above which there is no
/// solution.
inline constexpr double hopeless = 1e-7;

/// True if no shape has the fixed values at the ends and on the corridors without width. The test
/// starts at `z`.
bool contradictory(const ShapeModel& model, const Coordinates& z);

/// Returns a sentence on a constraint that is broken and that no free coordinate changes; nullopt
/// if all such constraints hold, or if the fixed values contradict each other.
std::optional<std::string> broken_where_fixed(const ShapeModel& model, const Coordinates& z);

/// Returns the constraints that conflict at z, the shape with the least common violation `slack`,
/// in words.
std::string worst_constraints(const ShapeModel& model, const Coordinates& z, double slack);

}  // namespace jounce::optimize_detail
