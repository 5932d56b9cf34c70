// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "jounce/drive/drive.hpp"
#include "jounce/validate/drive_stepper.hpp"

namespace jounce {

/// A servo axis of the validate module as the drive of an axis: actual position, velocity and
/// torque of the model, including its following error and its torque limit.
///
///     SimulatedDrive drive(servo_400w(), 0.001, config.position);
///     drive.command(drive_setpoint(tick, command));
///     drive.feedback().torque;                         // share of the rated torque
///
/// It follows setpoints from the cycle of its enable on. While it is not enabled, a brake holds it
/// at once at its position: it is then not ready, and has no torque. The torque is relative to the
/// rated torque of the motor, or to its limit if the model has no rated torque. It never reports a
/// fault: the axis supervises the following error.
///
/// It bridges missing setpoints like DriveStepper, up to 1000 cycles.
class SimulatedDrive final : public AxisDrive {
 public:
  /// `period` of the axis, s; it starts at `position`, u. Throws InputError like DriveStepper.
  SimulatedDrive(const Drive& drive, double period, double position = 0);

  void command(const DriveSetpoint& setpoint) noexcept override;
  [[nodiscard]] Feedback feedback() noexcept override;

  /// All signals of the model, for a plot; its time counts from the enable.
  [[nodiscard]] const DriveSample& now() const noexcept { return stepper_.now(); }

 private:
  DriveStepper stepper_;
  double rated_;    // N m
  double radians_;  // rad/u
  bool enabled_ = false;
  std::int64_t tick_ = 0;
};

}  // namespace jounce
