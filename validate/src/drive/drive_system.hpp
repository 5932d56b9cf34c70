// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "jounce/validate/drive.hpp"

#include "validate/src/linear/linear_system.hpp"

namespace jounce::validate_detail {

/// Outputs of a linear drive: torque, N m; angles of motor and load relative to the reference, rad;
/// speed of the motor, rad/s.
enum DriveRow : Eigen::Index {
  torque_row,
  motor_row,
  load_row,
  velocity_row,
  drive_rows,
  // Further watched outputs: the velocity of the load relative to the reference; the angle of a
  // pendulum relative to the load (0 without one); the torque that the controller demands; and
  // T + k w, which is limited at high speed (equation (9) of drive_system.cpp; k = 0 if the limit
  // does not depend on the speed).
  load_velocity_row = drive_rows,
  swing_row,
  demand_row,
  envelope_row,
  watched_rows
};

/// Returns a linear drive under a continuous controller, with the outputs up to drive_rows. The
/// equations are at the head of drive_system.cpp.
LinearSystem drive_system(const Drive& drive);
/// Returns the same with all outputs.
LinearSystem watched_drive(const Drive& drive);

/// Returns the torque that is lost for each rad/s above the rated velocity, k; 0 if the motor has
/// its peak torque at any speed.
double torque_slope(const Motor& motor);

/// Returns the drive without its controller. The commanded torque is the last state, and constant.
/// Angles are absolute: nothing depends on a reference.
LinearSystem open_drive(const Drive& drive);

/// Returns the state of rest of a system for a reference at rest: A x + B (1, 0, 0) = 0.
Eigen::VectorXd equilibrium(const LinearSystem& system);

/// The state of rest of an open drive that its controller holds.
struct OpenRest {
  std::vector<double> angles;  ///< angles relative to the reference, rad
  double torque = 0;           ///< torque of the motor, N m
};
OpenRest open_rest(const Drive& drive);

/// Sums of inertia (kg m^2) and viscous friction (N m s/rad), the gains of the feed-forward of a
/// sampled controller.
double total_inertia(const Drive& drive);
double total_friction(const Drive& drive);

}  // namespace jounce::validate_detail
