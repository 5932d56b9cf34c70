// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "jounce/profiles/moves/move.hpp"

namespace jounce::profiles_detail {

/// The fastest change from a state inside the bounds to a velocity and an acceleration, third
/// order.
class VelocityChange {
 public:
  VelocityChange() = default;
  VelocityChange(const MotionState& from, double velocity, double acceleration,
                 const Bounds& bounds) noexcept;

  [[nodiscard]] double first() const noexcept {
    return first_;
  }  ///< s: of the phases, 0 if left out
  [[nodiscard]] double last() const noexcept { return last_; }
  [[nodiscard]] double duration() const noexcept { return first_ + hold_ + last_; }
  [[nodiscard]] double distance() const noexcept { return distance_; }
  void append(Profile& out) const noexcept;

 private:
  double first_ = 0, hold_ = 0, last_ = 0;
  double first_jerk_ = 0, last_jerk_ = 0;
  double distance_ = 0;
};

/// Appends the fastest change from a state inside the bounds to a velocity and an acceleration,
/// third order; returns the state at its end.
MotionState change_velocity(const MotionState& from, double velocity, double acceleration,
                            const Bounds& bounds, Profile& profile) noexcept;

}  // namespace jounce::profiles_detail
