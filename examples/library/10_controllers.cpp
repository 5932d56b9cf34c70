// SPDX-License-Identifier: Apache-2.0
// The same motion in the words of four controllers: each command compiled to an exact profile.
#include <cstdio>

#include "jounce/controllers/agito/agito.hpp"
#include "jounce/controllers/googol/googol.hpp"
#include "jounce/controllers/himc/himc.hpp"
#include "jounce/controllers/pmc600/pmc600.hpp"
#include "jounce/profiles/curve/extrema.hpp"

using namespace jounce;

int main() {
  // Googol iDEABOX Pro, example 7-1, in pulse and ms: smoothTime costs its 25 ms.
  googol::Trap trap{.pos = 50000, .vel = 50, .acc = 0.25, .dec = 0.125};
  std::printf("Googol trap       %.6g ms", googol::trap(trap).duration());
  trap.smooth_time = 25;
  std::printf(", smoothed %.6g ms\n", googol::trap(trap).duration());
  const Profile percent =
      googol::move_absolute({.pos = 50000, .vel = 50, .acc = 0.25, .dec = 0.125, .percent = 50});
  std::printf("Googol percent 50 %.6g ms\n", percent.duration());

  // HIWIN HIMC, HMPL 5.1: T = Ta + Ts.
  const himc::AxisProfile himc{.velocity = 100, .acceleration_time = 200, .smoothing_time = 50};
  std::printf("HIMC              %.6g s, jerk %.6g mm/s^3\n",
              himc::move_abs(0, 1000, himc).duration(), himc::dynamics(himc).jerk);

  // Agito, 4.1 and 4.10.
  const agito::Settings agito{.accel = 100000, .decel = 100000, .speed = 1000};
  std::printf("Agito PTP         %.6g s\n", agito::begin(0, {.abs_trgt = 2000}, agito).duration());
  const Trajectory sine = agito::repetitive(0, {.rel_trgt = 400}, agito::quasi_sine(200, 5), 2);
  std::printf("Agito quasi-sine  %.6g s a period, at most %.6g\n", sine.end(),
              extrema(sine, 1).max.value);

  // PMC600, 6.3: the sigmoid takes the trapezoid's time at pi/2 times its acceleration.
  const Trajectory sigmoid = pmc600::move_absolute(
      0, 4000, {.velocity = 2000, .acceleration = 4000}, pmc600::VelocityMode::sigmoid);
  std::printf("PMC600 sigmoid    %.6g s, acceleration %.6g\n", sigmoid.end(),
              extrema(sigmoid, 2).max.value);
}

// > Googol trap       1300 ms, smoothed 1325 ms
// > Googol percent 50 1400 ms
// > HIMC              10.25 s, jerk 10000 mm/s^3
// > Agito PTP         2.01 s
// > Agito quasi-sine  0.2 s a period, at most 8000
// > PMC600 sigmoid    2.5 s, acceleration 6283.19
