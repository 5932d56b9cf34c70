// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "validate/src/drive/drive_response.hpp"
#include "validate/src/identify/setpoint_curve.hpp"

namespace jounce::validate_detail {

/// Instants at which a linear drive is stepped: `start` + k `period`.
struct Grid {
  double start = 0;   ///< s
  double period = 0;  ///< s, a cycle of a sampled controller or of the setpoints
};

/// Returns the grid of a motion. nullopt: the drive cannot be stepped along the motion, because it is
/// not linear, its controller is continuous and the setpoints are not known, or a sample or a setpoint is
/// between two cycles.
std::optional<Grid> grid_of(const Commanded& command, const ResponseSpec& spec);

/// Computes the response like respond(), by DriveStepper. The derivatives are central differences of
/// such responses, which are exact up to rounding.
DriveResponse stepped_response(const Commanded& command, const Grid& grid,
                               const ResponseSpec& spec);

/// Computes the values without their derivatives.
DriveResponse stepped_values(const Commanded& command, const Grid& grid, const ResponseSpec& spec);

}  // namespace jounce::validate_detail
