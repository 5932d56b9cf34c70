// SPDX-License-Identifier: Apache-2.0
// A jerk-limited move, its exact peaks, its limits, and the way back.
#include <cmath>
#include <cstdio>

#include "jounce/profiles/curve/extrema.hpp"
#include "jounce/profiles/limits/limits.hpp"
#include "jounce/profiles/moves/s_curve.hpp"

using namespace jounce;

int main() {
  const Trajectory move =
      s_curve({.to = 50, .velocity = 10, .acceleration = 20, .jerk = 100}).curve();
  const Motion now = move.at(0.25);
  std::printf("%.4g s; at 0.25 s: %.4g at %.4g\n", move.end(), now.position, now.velocity);

  const Range speed = extrema(move, 1);
  std::printf("fastest %.4g at %.4g s\n", speed.max.value, speed.max.where);

  const Trajectory both = concatenated(move, reversed(move));
  const Report report = check(both, {.velocity = 8});
  const Finding& worst = report.findings.front();
  std::printf("%s: %.4g exceeds %.4g by %.0f %%\n", worst.rule.text().c_str(),
              std::abs(worst.value), std::abs(worst.limit), -100 * worst.margin);
}

// > 5.7 s; at 0.25 s: 0.2583 at 3
// > fastest 10 at 0.7 s
// > limit/velocity: 10 exceeds 8 by 25 %
