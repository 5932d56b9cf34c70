// SPDX-License-Identifier: Apache-2.0
// A stage that must not shake: the jounce limited too, and what that costs against an S-curve.
#include <cstdio>

#include "jounce/profiles/curve/extrema.hpp"
#include "jounce/profiles/limits/limits.hpp"
#include "jounce/profiles/moves/fourth_order.hpp"
#include "jounce/profiles/moves/s_curve.hpp"

using namespace jounce;

int main() {
  const FourthOrderSpec spec{
      .to = 1, .velocity = 0.9, .acceleration = 4, .jerk = 40, .jounce = 1000};
  const Trajectory move = fourth_order(spec);
  const double third =
      s_curve({.to = 1, .velocity = 0.9, .acceleration = 4, .jerk = 40}).duration();
  std::printf("%zu phases, %.4f s; an S-curve takes %.4f s\n", move.segments().size(),
              move.length(), third);

  const Report report = check(move, {.velocity = 0.9, .acceleration = 4, .jerk = 40});
  std::printf("limits %s, jerk continuous: %s\n", report.ok() ? "held" : "broken",
              check_continuity(move, 3).ok() ? "yes" : "no");
  std::printf("greatest jerk %.4g u/s^3\n", extrema(move, 3).max.value);
}

// > 15 phases, 1.4761 s; an S-curve takes 1.4361 s
// > limits held, jerk continuous: yes
// > greatest jerk 40 u/s^3
