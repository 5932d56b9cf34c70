// SPDX-License-Identifier: Apache-2.0
// Smoothing a trapezoid, and three ways to keep a load on a spring from swinging.
#include <cstdio>
#include <vector>

#include "jounce/profiles/curve/extrema.hpp"
#include "jounce/profiles/moves/s_curve.hpp"
#include "jounce/profiles/vibration/moving_average.hpp"
#include "jounce/profiles/vibration/notch.hpp"
#include "jounce/profiles/vibration/shaper.hpp"

using namespace jounce;

int main() {
  // HIMC HMPL manual 5.1: v 100, a 500, smoothing time 50 ms.
  const Trajectory hard = trapezoid({.to = 40, .velocity = 100, .acceleration = 500}).curve();
  const Trajectory move = moving_average(hard, 0.05);
  std::printf("jerk %.0f, ramp %.0f ms\n", extrema(move, 3).max.value, 1e3 * move.breaks()[3]);

  const Mode mode{.frequency = 5.5, .damping = 0.03};
  std::printf("unshaped: %.3f mm left after %.3f s\n", residual_vibration(move, mode), move.end());
  for (const auto& [name, kind] :
       {std::pair{"zv", ShaperKind::zv}, {"zvd", ShaperKind::zvd}, {"ei", ShaperKind::ei}}) {
    const std::vector<Impulse> impulses = shaper({kind, mode});
    const Trajectory quiet = shaped(move, impulses);
    const WorstResidual off = worst_residual(impulses, mode.damping, 0.9 * 5.5, 1.1 * 5.5);
    std::printf("%s: %.3f mm left after %.3f s; 10 %% off at most %.1f %% of unshaped\n", name,
                residual_vibration(quiet, mode), quiet.end(), 100 * off.residual);
  }
  const Notched notch = notched(move, {.frequency = 5.5, .mode_damping = 0.03});
  std::printf("notch: %.3f mm left after %.3f s, within %.0e mm of the exact response\n",
              residual_vibration(notch.motion, mode), notch.motion.end(), notch.error);
}

// > jerk 10000, ramp 250 ms
// > unshaped: 0.212 mm left after 0.650 s
// > zv: 0.000 mm left after 0.741 s; 10 % off at most 15.0 % of unshaped
// > zvd: 0.000 mm left after 0.832 s; 10 % off at most 2.2 % of unshaped
// > ei: 0.011 mm left after 0.832 s; 10 % off at most 5.0 % of unshaped
// > notch: 0.000 mm left after 1.120 s, within 7e-05 mm of the exact response
