// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "jounce/profiles/curve/curve.hpp"
#include "jounce/profiles/vibration/vibration.hpp"

namespace jounce::test {

/// Position and velocity of a second-order system.
struct Load {
  double x = 0;
  double v = 0;
};

/// Integrates x'' = g(x, v, t) from t0 to t1 in n steps of the classical Runge-Kutta method.
template <class Force>
Load integrated(Load s, double t0, double t1, int n, Force force) {
  const double h = (t1 - t0) / n;
  for (int i = 0; i < n; ++i) {
    const double t = t0 + h * i;
    const double a1 = force(s.x, s.v, t);
    const double v2 = s.v + h / 2 * a1;
    const double a2 = force(s.x + h / 2 * s.v, v2, t + h / 2);
    const double v3 = s.v + h / 2 * a2;
    const double a3 = force(s.x + h / 2 * v2, v3, t + h / 2);
    const double v4 = s.v + h * a3;
    const double a4 = force(s.x + h * v3, v4, t + h);
    s = {s.x + h / 6 * (s.v + 2 * v2 + 2 * v3 + v4), s.v + h / 6 * (a1 + 2 * a2 + 2 * a3 + a4)};
  }
  return s;
}

/// A load on a spring behind the motion, at rest before, at the motion's end: no code in common with
/// the closed forms. Steps end at the breaks.
inline Load after(const Trajectory& motion, const Mode& mode) {
  const double w = 2 * std::acos(-1.0) * mode.frequency;
  Load load{motion.at(motion.start()).position, 0};
  for (std::size_t i = 0; i < motion.segments().size(); ++i) {
    const Segment& f = motion.segments()[i];
    const double t0 = motion.breaks()[i];
    const auto n = static_cast<int>(200 + 600 * w * f.length);
    load = integrated(load, t0, t0 + f.length, n, [&](double x, double v, double t) {
      return w * w * (value(f, (t - t0) / f.length) - x) - 2 * mode.damping * w * v;
    });
  }
  return load;
}

}  // namespace jounce::test
