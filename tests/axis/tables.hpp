// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include "jounce/pvt/table.hpp"

#include "axis/bench.hpp"

namespace jounce::test {

using TablePtr = std::shared_ptr<const Table>;

inline TablePtr table(Domain axis, Interpolation rule, Extrapolation outside, Columns columns) {
  return std::make_shared<const Table>(axis, rule, outside, std::move(columns));
}

/// PMC600 manual Fig. 6.14: 360 by 232 pulses, quintics, periodic.
inline TablePtr pmc600_cam() {
  return table(Domain::master, Interpolation::quintic_hermite, Extrapolation::wrap,
               {{0, 75, 200, 280, 360},
                {0, 100, 225, 100, 0},
                {0, 1, 1, 0.01739120485, 0},
                {0, 0, 0, 0, 0}});
}

/// A master at constant velocity.
inline TablePtr constant_master(double distance, double velocity) {
  return table(Domain::time, Interpolation::linear, Extrapolation::hold,
               {{0, distance / velocity}, {0, distance}, {}, {}});
}

/// The trapezoid from rest to rest, exactly: cubics hold its parabolas.
inline TablePtr trapezoid_table(double distance, double v, double a, double d,
                                Extrapolation outside = Extrapolation::hold) {
  const double ta = v / a;
  const double td = v / d;
  const double tc = (distance - v * (ta + td) / 2) / v;
  return table(Domain::time, Interpolation::cubic_hermite, outside,
               {{0, ta, ta + tc, ta + tc + td},
                {0, v * ta / 2, v * ta / 2 + v * tc, distance},
                {0, v, v, 0},
                {}});
}

/// There and back by the 3-4-5 polynomial, `reach` in T/2 each way.
inline TablePtr there_and_back(double from, double reach, double T, Extrapolation outside) {
  return table(Domain::time, Interpolation::quintic_hermite, outside,
               {{0, T / 2, T}, {from, from + reach, from}, {0, 0, 0}, {0, 0, 0}});
}

}  // namespace jounce::test
