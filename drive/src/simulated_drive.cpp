// SPDX-License-Identifier: Apache-2.0
#include "jounce/drive/simulated_drive.hpp"

#include <algorithm>
#include <numbers>

namespace jounce {

SimulatedDrive::SimulatedDrive(const Drive& drive, double period, double position)
    : stepper_(drive, period),
      rated_(drive.motor.rated_torque > 0 ? drive.motor.rated_torque : drive.motor.torque_limit),
      radians_(2 * std::numbers::pi / drive.position_per_rev) {
  stepper_.rest(position);
}

void SimulatedDrive::command(const DriveSetpoint& setpoint) noexcept {
  const std::int64_t periods = std::clamp<std::int64_t>(setpoint.tick - tick_, 1, 1000);
  tick_ = setpoint.tick;
  if (enabled_ && !setpoint.enable) stepper_.rest(stepper_.now().motor);
  enabled_ = setpoint.enable;
  if (!enabled_) return;
  stepper_.step({setpoint.position, setpoint.velocity, setpoint.acceleration, 0},
                static_cast<int>(periods));
}

Feedback SimulatedDrive::feedback() noexcept {
  const DriveSample& now = stepper_.now();
  return {.position = now.motor,
          .velocity = enabled_ ? now.velocity / radians_ : 0,
          .torque = enabled_ ? now.torque / rated_ : 0,
          .ready = enabled_};
}

}  // namespace jounce
