// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "jounce/drive/drive.hpp"
#include "jounce/validate/drive_stepper.hpp"

namespace jounce {

/// A drive model of the module validate, as the drive of an axis. It reports the position, velocity
/// and torque of the model. The model has a following error and a torque limit, like a real drive.
///
///     SimulatedDrive drive(servo_400w(), 0.001, config.position);
///     drive.command(drive_setpoint(tick, command));
///     drive.feedback().torque;                         // share of the rated torque
///
/// The drive follows setpoints from the cycle in which it is enabled. While it is disabled, a brake
/// holds it at its position; it is then not ready, and its torque is 0. The torque is relative to
/// the rated torque of the motor or, if the model has no rated torque, to the torque limit. The
/// drive never reports a fault, because the axis supervises the following error.
///
/// If setpoints are missing, the drive interpolates like DriveStepper, over at most 1000 cycles.
class SimulatedDrive final : public AxisDrive {
 public:
  /// `period`: duration of a cycle of the axis, s. `position`: initial position, u (the unit of the
  /// axis). Throws InputError like DriveStepper.
  SimulatedDrive(const Drive& drive, double period, double position = 0);

  void command(const DriveSetpoint& setpoint) noexcept override;
  [[nodiscard]] Feedback feedback() noexcept override;

  /// All signals of the model, for a plot. Their time counts from the cycle in which the drive was
  /// enabled.
  [[nodiscard]] const DriveSample& now() const noexcept { return stepper_.now(); }

 private:
  DriveStepper stepper_;
  double rated_;    // N m
  double radians_;  // rad/u
  bool enabled_ = false;
  std::int64_t tick_ = 0;
};

}  // namespace jounce
