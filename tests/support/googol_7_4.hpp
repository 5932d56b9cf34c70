// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <vector>

#include "jounce/pvt/pt.hpp"

namespace jounce::test {

/// Googol's example 7-4: v = 50 sin(2 pi t), 16 ms steps, trapezoid rule, a STOP in the last 8 ms of each
/// of two loops; the manual's pi. `unit`: that of time, ms.
inline std::vector<PtPoint> example_7_4(double unit) {
  const double pi = 3.1415926;
  std::vector<PtPoint> points;
  for (int loop = 1; loop <= 2; ++loop) {
    double position = 0;
    double before = 0;
    for (int k = 1; k * 16 < 1000; ++k) {
      const double v = 50 * std::sin(2 * pi * k * 0.016);
      position += (before + v) * 8;
      before = v;
      points.push_back({(1000.0 * (loop - 1) + 16 * k) / unit, position});
    }
    points.push_back({1000.0 * loop / unit, 0, PtType::stop});
  }
  return points;
}

}  // namespace jounce::test
