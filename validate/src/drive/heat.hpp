// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "jounce/validate/drive.hpp"

namespace jounce::validate_detail {

/// The share of the winding's thermal limit, from cold: h' = (T^2 / rated^2 - h) / tau.
class Heat {
 public:
  explicit Heat(const Motor& motor)
      : rated_(motor.rated_torque * motor.rated_torque), time_(motor.thermal_time) {}

  /// The value after another dt, over which T^2 integrates to `squared`, as if T^2 were constant at its mean. 0
  /// if it is not modeled.
  double after(double dt, double squared) {
    if (time_ == 0) return 0;
    share_ += (squared / (dt * rated_) - share_) * -std::expm1(-dt / time_);
    return share_;
  }

 private:
  double rated_;
  double time_;
  double share_ = 0;
};

/// The figures that follow from the torque if the motor's torque constant is given; `squared`: integral of T^2
/// over reference and standstill. The rms current needs rms_torque.
inline void add_current(DriveResult& found, const Motor& motor, double squared) {
  const double constant = motor.torque_constant;
  if (constant == 0) return;
  found.current = {found.torque.value / constant, found.torque.where};
  found.rms_current = found.rms_torque / constant;
  found.energy.copper = squared * motor.resistance / (constant * constant);
}

}  // namespace jounce::validate_detail
