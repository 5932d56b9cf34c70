// SPDX-License-Identifier: Apache-2.0
// Setpoints cycle by cycle: targets, limits and goals that change while the axes move.
#include <cstdio>

#include "jounce/profiles/online/online.hpp"

using namespace jounce;

int main() {
  OnlineGenerator<2> xy(Sync::time);
  xy.set_bounds(0, within(2, 10, 100));  // u/s, u/s^2, u/s^3
  xy.set_bounds(1, within(1, 5, 50));
  xy.set_target(0, {.position = 1});
  xy.set_target(1, {.position = -0.5});
  int cycles = 1;
  while (!xy.step(0.001).arrived) ++cycles;
  std::printf("both at (%g, %g) after %d cycles\n", xy[0].position, xy[1].position, cycles);

  // A carton on a belt at 0.3 u/s, as its sensor sees it: noise of 1e-5 u. One plan.
  OnlineGenerator<1> pusher;
  pusher.set_bounds(0, within(2, 10, 100));
  pusher.set_tolerance(0, 1e-4);
  int plans = 0;
  double t = 0;
  double noise = 1e-5;
  for (bool there = false; !there; t += 0.001) {
    noise = -noise;
    pusher.set_target(0, {.position = 1 + 0.3 * t + noise, .velocity = 0.3}, MoveGoal::moving);
    const OnlineStep step = pusher.step(0.001);
    plans += step.planned ? 1 : 0;
    there = step.arrived;
  }
  std::printf("met at %.4f after %.3f s, planned %d time\n", pusher[0].position, t, plans);

  // The acceleration limit is lowered while the axis brakes at 10 u/s^2: it needs those to stop in time.
  OnlineGenerator<1> axis;
  axis.set_bounds(0, within(2, 10, 100));
  axis.set_target(0, {.position = 2});
  for (int k = 0; k < 1100; ++k) (void)axis.step(0.001);
  axis.set_bounds(0, within(2, 3, 100));
  double highest = 0;
  while (!axis.step(0.001).arrived)
    if (axis[0].position > highest) highest = axis[0].position;
  std::printf("stands at %g, never beyond %.6f\n", axis[0].position, highest);

  // A jog, and a direction that is forbidden while it runs.
  axis.set_velocity(0, 1);
  for (int k = 0; k < 1000; ++k) (void)axis.step(0.001);
  std::printf("jogs at %g u/s\n", axis[0].velocity);
  Bounds backwards = within(2, 10, 100);
  backwards.velocity_max = 0;
  axis.set_bounds(0, backwards);
  for (int k = 0; k < 1000; ++k) (void)axis.step(0.001);
  std::printf("rests at %.6g\n", axis[0].position);
}

// > both at (1, -0.5) after 800 cycles
// > met at 1.2700 after 0.900 s, planned 1 time
// > stands at 2, never beyond 2.000000
// > jogs at 1 u/s
// > rests at 2.91833
