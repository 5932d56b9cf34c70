// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "jounce/drive/drive.hpp"
#include "jounce/validate/drive_stepper.hpp"

namespace jounce {

/// A servo axis of the validate module as the drive of an axis: actual position, velocity and torque
/// as the model has them, its following error and its torque limit included.
///
///     SimulatedDrive drive(servo_400w(), 0.001, config.position);
///     drive.command(drive_setpoint(tick, command));
///     drive.feedback().torque;                         // share of the rated one
///
/// It follows from the cycle on in which it is enabled. Where it is not, a brake holds it at once where it
/// is: then it is not ready, and has no torque. The torque is relative to the rated torque of the motor, or
/// of its limit where the model has no rated torque. It never has a fault of its own: what is too far
/// behind is the axis's to judge.
///
/// Setpoints that were left out are bridged as DriveStepper does, up to 1000 cycles of them.
class SimulatedDrive final : public AxisDrive {
 public:
  /// `period` of the axis, s; it stands at `position`, u. Throws InputError as DriveStepper.
  SimulatedDrive(const Drive& drive, double period, double position = 0);

  void command(const DriveSetpoint& setpoint) noexcept override;
  [[nodiscard]] Feedback feedback() noexcept override;

  /// All signals of the model, for a picture; its time counts from the enable.
  [[nodiscard]] const DriveSample& now() const noexcept { return stepper_.now(); }

 private:
  DriveStepper stepper_;
  double rated_;    // N m
  double radians_;  // rad/u
  bool enabled_ = false;
  std::int64_t tick_ = 0;
};

}  // namespace jounce
