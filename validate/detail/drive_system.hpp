#pragma once

#include "jounce/validate/detail/linear_system.hpp"
#include "jounce/validate/drive.hpp"

namespace jounce::detail {

/// The outputs of a linear drive, in N m and, of the angles, in rad relative to the reference.
enum DriveRow : Eigen::Index { torque_row, motor_row, load_row, drive_rows };

/// A linear drive under a continuous controller. The equations stand at the head of drive_system.cpp.
LinearSystem drive_system(const Drive& drive);

/// The same without a controller: the commanded torque is the last state, and constant. Angles are
/// absolute: nothing depends on a reference.
LinearSystem open_drive(const Drive& drive);

/// What a sampled controller multiplies, in N m per rad/s and rad/s^2.
double total_inertia(const Drive& drive);
double total_friction(const Drive& drive);

}  // namespace jounce::detail
