// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "jounce/profiles/curve/jet.hpp"

namespace jounce::validate_detail {

/// The curve that a drive derives from two setpoints, T apart: the quintic through position,
/// velocity and acceleration of both. If their velocities do not match their positions (at a
/// corner, or with a frozen setpoint), the straight line.
class SteppedReference {
 public:
  static constexpr std::size_t derivatives = 5;

  SteppedReference() = default;
  /// The curve from one setpoint to the next, T s later.
  SteppedReference(const Jet& from, const Jet& to, double T);

  /// Returns position (relative to `from`), velocity, acceleration and jerk at t, 0 <= t <= T.
  [[nodiscard]] Jet at(double t) const;
  /// Returns r', r'', ..., r^(5) at t.
  [[nodiscard]] std::array<double, derivatives> rates(double t) const;

 private:
  std::array<double, derivatives + 1> c_{};  // sum of c_k t^k, c_0 = 0
};

}  // namespace jounce::validate_detail
