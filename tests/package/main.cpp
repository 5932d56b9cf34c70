// SPDX-License-Identifier: Apache-2.0
#include <cstdio>

#include <jounce/profiles/curve/extrema.hpp>
#include <jounce/profiles/moves/s_curve.hpp>
#include <jounce/profiles/online/online.hpp>

int main() {
  const jounce::Trajectory move =
      jounce::trapezoid({.to = 50000, .velocity = 50, .acceleration = 0.25, .deceleration = 0.125})
          .curve();
  const jounce::Range v = jounce::extrema(move, 1);
  jounce::OnlineGenerator<1> axis;
  axis.set_bounds(0, jounce::within(2, 10, 100));
  if (!axis.step(0.001).arrived) return 1;
  std::printf("%g ms, at most %g pulse/ms\n", move.end(), v.max.value);
}
