// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>

#include "jounce/profiles/curve/jet.hpp"
#include "jounce/validate/drive.hpp"

namespace jounce {

/// A linear drive that is stepped together with the cycle of an axis. The class computes the result
/// of drive_through() one setpoint at a time, for an executor that receives the motion step by
/// step. u is the unit of the setpoints.
///
///     DriveStepper drive(servo_400w(), 0.001);
///     drive.rest(0);                                       // u, where it stands
///     const DriveSample now = drive.step({10e-6, 0.03, 60, 0});
///     now.motor;                                           // u, at the end of that period
///
/// **Reference.** Between two setpoints, the reference is the quintic through their positions,
/// velocities and accelerations. If these numbers do not fit together, as at a corner, it is a
/// straight line. After step(r(t_k)), the sample is the state of the drive at t_k.
///
/// **Accuracy.** The drive is solved by matrix exponentials, which the constructor computes, exact
/// up to rounding. The instant at which the torque reaches the limit of the motor is found to 1/256
/// of a period. For a motion with a continuous acceleration and a thousand setpoints, the result
/// agrees with drive_through() to 1e-7 of the stroke (checked by tests). A step of the acceleration
/// between two setpoints adds an error of about (size of the step) times period^2, which decays
/// with the time constants of the drive.
///
/// **Controller.** A controller with a cycle reads, limits, rounds and delays as in
/// drive_through(); its cycle must divide the period. The delay of a controller without a cycle is
/// a Pade approximant, as in drive_through().
///
/// step() and rest() do not allocate or throw. A step of servo_400w() takes about half a
/// microsecond.
class DriveStepper {
 public:
  /// `period` is the duration of a cycle, s, > 0. Throws InputError like require_valid(); for a
  /// drive that is not linear (see nonlinearity() in linear_drive.hpp; encoder counts and the
  /// limits of the motor are permitted); and for a controller whose cycle does not divide the
  /// period into at most 1000 cycles, or whose delay is more than 1000 cycles. At first, the drive
  /// is at rest at 0.
  DriveStepper(const Drive& drive, double period);
  ~DriveStepper();
  DriveStepper(DriveStepper&&) noexcept;
  DriveStepper& operator=(DriveStepper&&) noexcept;

  /// Sets the drive at rest at `position`, u, in equilibrium with the output of its controller.
  void rest(double position) noexcept;
  /// Adds `by` (u) to all positions: changes the coordinate without a motion.
  void rename(double by) noexcept;
  /// Moves the reference to `to` (u, u/s, u/s^2) in this number of periods, 1 to 1000. Returns the
  /// sample at the end of the last period.
  const DriveSample& step(const Jet& to, int periods = 1) noexcept;

  /// The last sample. Its time counts from rest().
  [[nodiscard]] const DriveSample& now() const noexcept { return now_; }

 private:
  struct Model;

  std::unique_ptr<Model> model_;
  double period_;
  double unit_;  // u/rad
  std::int64_t periods_ = 0;
  Jet reference_{};
  DriveSample now_{};
};

}  // namespace jounce
