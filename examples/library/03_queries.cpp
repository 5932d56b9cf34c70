// SPDX-License-Identifier: Apache-2.0
// Queries of a planner before a move: stopping distance, entry velocity, peak, time; one by one and many.
#include <cstdio>
#include <vector>

#include "jounce/profiles/curve/query.hpp"
#include "jounce/profiles/moves/batch.hpp"

using namespace jounce;

int main() {
  const Ramp ramp{.acceleration = 20, .jerk = 100};  // u/s^2, u/s^3
  const Extent room = stopping({.velocity = 10}, ramp).value();
  std::printf("from 10 u/s it takes %.4g s and %.4g u to stop\n", room.duration, room.distance);
  std::printf("so one may enter the last %.4g u with %.4g u/s\n", room.distance,
              entry_velocity(room.distance, 0, ramp).value());
  std::printf("over 5 u the peak is %.4g u/s\n", peak_velocity(5, {}, ramp).value());
  if (!peak_velocity(3, {.entry = 10}, ramp)) std::puts("3 u are too short to stop from 10 u/s");

  const std::vector<double> ways{0.5, 5, 50}, velocity{10}, acceleration{20}, jerk{100};
  std::vector<double> seconds(ways.size());
  minimum_durations(
      {.distance = ways, .velocity = velocity, .acceleration = acceleration, .jerk = jerk},
      seconds);
  for (std::size_t i = 0; i < ways.size(); ++i) std::printf("%4g u: %.4f s\n", ways[i], seconds[i]);
}

// > from 10 u/s it takes 0.7 s and 3.5 u to stop
// > so one may enter the last 3.5 u with 10 u/s
// > over 5 u the peak is 8.198 u/s
// > 3 u are too short to stop from 10 u/s
// >  0.5 u: 0.5429 s
// >    5 u: 1.2198 s
// >   50 u: 5.7000 s
