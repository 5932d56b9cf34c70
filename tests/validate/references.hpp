// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "jounce/profiles/curve/curve.hpp"
#include "jounce/profiles/curve/jet.hpp"
#include "jounce/profiles/moves/s_curve.hpp"

namespace jounce::test {

/// A signal made from a function: for signals that lie, fail, or throw.
struct MadeUp {
  std::function<Jet(double, Side)> f;
  std::vector<double> at{0, 1};

  [[nodiscard]] double start() const { return at.front(); }
  [[nodiscard]] double end() const { return at.back(); }
  [[nodiscard]] std::span<const double> breaks() const { return at; }
  [[nodiscard]] Jet jet(double x, Side side) const { return f(x, side); }
};

/// Ten turns of a motor whose unit is the degree, brisk for the drive servo_400w.
inline Trajectory trapezoid_move() {
  return trapezoid({.from = 0, .to = 3600, .velocity = 9000, .acceleration = 60'000}).curve();
}

inline Trajectory s_curve_move() {
  return s_curve({.from = 0, .to = 3600, .velocity = 9000, .acceleration = 60'000, .jerk = 2e6})
      .curve();
}

/// The 3-4-5 law, one segment.
inline Trajectory law_345(double stroke, double time) {
  return Trajectory({quintic(time, 0, 0, 0, stroke, 0, 0)}, 0, Extrapolation::hold);
}

}  // namespace jounce::test
