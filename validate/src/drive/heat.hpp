// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "jounce/validate/drive.hpp"

namespace jounce::validate_detail {

/// The thermal load h of the winding as a share of its limit, from the cold state: h' = (T^2 /
/// rated^2 - h) / tau.
class Heat {
 public:
  explicit Heat(const Motor& motor)
      : rated_(motor.rated_torque * motor.rated_torque), time_(motor.thermal_time) {}

  /// Returns the load after another `dt` s. `squared`: integral of T^2 over this time; T^2 counts
  /// as constant. 0 if the motor has no thermal model.
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

/// Adds the figures that follow from the torque, if the motor has a torque constant. `squared`:
/// integral of T^2 over reference and standstill. rms_torque must be set before.
inline void add_current(DriveResult& found, const Motor& motor, double squared) {
  const double constant = motor.torque_constant;
  if (constant == 0) return;
  found.current = {found.torque.value / constant, found.torque.where};
  found.rms_current = found.rms_torque / constant;
  found.energy.copper = squared * motor.resistance / (constant * constant);
}

}  // namespace jounce::validate_detail
