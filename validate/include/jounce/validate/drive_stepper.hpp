// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>

#include "jounce/profiles/curve/jet.hpp"
#include "jounce/validate/drive.hpp"

namespace jounce {

/// A linear drive stepped in time with an axis's cycle: the result of drive_through() for one
/// setpoint at a time, for an executor that receives the motion step by step.
///
///     DriveStepper drive(servo_400w(), 0.001);
///     drive.rest(0);                                       // u, where it stands
///     const DriveSample now = drive.step({10e-6, 0.03, 60, 0});
///     now.motor;                                           // u, at the end of that period
///
/// Between two setpoints the reference is the quintic with position, velocity and acceleration of
/// both, or a straight line if these contradict each other, as at a corner. So after step(r(t_k))
/// the sample is the drive's state at t_k. For a motion with a continuous acceleration it agrees
/// with drive_through() within 1e-7 of the stroke at a thousand setpoints (pinned by tests). Each
/// step of the acceleration between two setpoints adds an error of the size of that step times
/// period^2, which decays with the drive's own time constants.
///
/// The drive itself is solved by matrix exponentials from the constructor, exact except for
/// rounding. The instant at which its torque reaches the motor's limit is found within 1/256 of a
/// period. A controller with a cycle reads, limits, rounds and delays as in drive_through(); its
/// cycle must divide the period. The delay of a controller without a cycle is a Pade approximant,
/// as there.
///
/// step() and rest() do not allocate or throw. A step of servo_400w() takes about half a
/// microsecond.
class DriveStepper {
 public:
  /// `period` > 0, s. Throws InputError like require_valid(), for a drive that is not linear
  /// (nonlinearity(); encoder counts and the motor's limits may be), and for a cycle that does not
  /// divide the period.
  DriveStepper(const Drive& drive, double period);
  ~DriveStepper();
  DriveStepper(DriveStepper&&) noexcept;
  DriveStepper& operator=(DriveStepper&&) noexcept;

  /// Puts the drive at rest at `position`, u, in equilibrium with the output of its controller.
  void rest(double position) noexcept;
  /// The same place under another name: `by` u more than before.
  void rename(double by) noexcept;
  /// The reference moves to `to` (u, u/s, u/s^2) within this number of periods, 1 to 1000.
  const DriveSample& step(const Jet& to, int periods = 1) noexcept;

  /// The last sample. Its time counts the periods since rest().
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
