// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "jounce/validate/drive.hpp"

#include "validate/src/drive/drive_model.hpp"
#include "validate/src/linear/stepped_reference.hpp"

namespace jounce::validate_detail {

/// A linear drive under a sampled controller (struct Controller), over periods of a whole number of
/// its cycles. Between the instants at which the torque changes, a step is an exponential. At each
/// reading the controller acts with its encoder, its limit and its delay. Only the constructor
/// allocates.
class SampledStepper {
 public:
  /// Throws InputError if the period is not a whole number of cycles.
  SampledStepper(const Drive& drive, double period);

  /// Sets the drive to rest. `position`: u, measured from the zero of the encoder.
  void rest(double position);
  /// Steps the drive along the reference, over this number of periods.
  void step(const SteppedReference& reference, int periods);
  /// Returns the state at the end of the last step, with motor and load relative to the place of
  /// rest. `unit`: u for one radian of the motor.
  [[nodiscard]] DriveSample sample(double unit) const;
  /// Distance that the reference has moved since rest(), u.
  [[nodiscard]] double moved() const { return moved_; }

 private:
  using Matrix = std::vector<double>;  // states by states, by columns

  void advance(const Matrix& m);
  void read(const Jet& r);
  void give();
  [[nodiscard]] double output(std::size_t row) const;

  Drive drive_;
  DriveModel limits_;
  double inertia_, viscous_;
  double radians_;  // per u
  double count_;    // rad; 0: exact
  int cycles_;      // a period
  std::size_t states_;
  bool split_ = false;  // the torque changes between two readings
  Matrix before_;       // from a reading to the change of torque, or to the next reading
  Matrix after_;
  Matrix outputs_;
  std::vector<double> rest_;
  double rest_torque_ = 0;
  double torque_scale_ = 1;
  std::vector<double> x_;
  std::vector<double> next_;
  std::vector<double> due_;  // torques on their way, a ring
  std::size_t read_ = 0;     // readings made
  double zero_ = 0;          // rad, of the encoder at the place of rest
  double moved_ = 0;         // u
  double angle_ = 0;         // last reading
  double integral_ = 0;
};

}  // namespace jounce::validate_detail
