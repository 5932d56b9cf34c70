// SPDX-License-Identifier: Apache-2.0
// Two axes through four points: stopping at each, and without stopping.
#include <cstdio>

#include "jounce/profiles/sequences/via.hpp"

using namespace jounce;

int main() {
  // The points of PMC600 manual 8.2.5, example 8.6.
  const Bounds axis = within(1000, 2000, 20000);  // u/s, u/s^2, u/s^3
  const ViaMotion m =
      via({.axes = {axis, axis}, .points = {{0, 0}, {1000, 1000}, {3000, 2000}, {4000, 0}}});
  std::printf("%.3f s, with stops %.3f s\n", m.duration, m.stopping_duration);
  for (const ViaKnot& knot : m.knots)
    std::printf("%.3f s: at %4.0f, %4.0f with %5.0f, %5.0f\n", knot.time,
                m.axes[0].at(knot.time).position, m.axes[1].at(knot.time).position,
                knot.velocity[0], knot.velocity[1]);
}

// > 5.851 s, with stops 6.800 s
// > 0.000 s: at    0,    0 with     0,     0
// > 1.300 s: at 1000, 1000 with  1000,  1000
// > 3.300 s: at 3000, 2000 with  1000,     0
// > 5.851 s: at 4000,    0 with     0,     0
