// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "jounce/validate/drive.hpp"

#include "validate/src/linear/linear_system.hpp"

namespace jounce::validate_detail {

/// The outputs of a linear drive: N m; angles in rad relative to the reference; the motor's own rad/s.
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

/// A linear drive under a continuous controller, rows up to drive_rows. The equations are at the head of
/// drive_system.cpp.
LinearSystem drive_system(const Drive& drive);
/// The same with all watched outputs.
LinearSystem watched_drive(const Drive& drive);

/// The torque lost per rad/s beyond the rated velocity, k; 0 where the motor has its peak at any speed.
double torque_slope(const Motor& motor);

/// The same without a controller: the commanded torque is the last state, and constant. Angles are
/// absolute: nothing depends on a reference.
LinearSystem open_drive(const Drive& drive);

/// The state of rest of a system on a reference at rest: A x + B (1, 0, 0) = 0.
Eigen::VectorXd equilibrium(const LinearSystem& system);

/// The same of an open drive, held by its controller: the angles, relative to the reference, and the
/// torque.
struct OpenRest {
  std::vector<double> angles;
  double torque = 0;
};
OpenRest open_rest(const Drive& drive);

/// The gains of a sampled controller, in N m per rad/s and rad/s^2.
double total_inertia(const Drive& drive);
double total_friction(const Drive& drive);

}  // namespace jounce::validate_detail
