// SPDX-License-Identifier: Apache-2.0
// A slave that stands beside its cam is coupled to a master at speed, in every start mode.
#include <cstdio>

#include "jounce/cam/coupling/coupling_cycle.hpp"
#include "jounce/cam/design/design.hpp"

using namespace jounce;

int main() {
  // PMC600 manual 6.2, Fig. 6.14: pulses over pulses, periodic.
  CamSpec spec;
  spec.start = {0, 0, 0, 0};
  spec.segments = {{Law::quintic, {75, 100, 1, 0}, "catch up"},
                   {Law::quintic, {200, 225, 1, 0}, "in step"},
                   {Law::quintic, {280, 100, 0.01739120485, 0}, "return"},
                   {Law::quintic, {360, 0, 0, 0}, "settle"}};
  spec.periodic = true;
  const Cam cam = design(spec).cam;

  // The master runs at 200 pulse/s and is at 100; the slave stands at 80, its cam is at 125.
  const MotionState slave{.position = 80};
  const auto master = [](double t) { return Sample{t, {100 + 200 * t, 200, 0, 0}}; };
  for (std::size_t mode = 0; mode < start_mode_count; ++mode) {
    const Coupling coupling(cam, {.start = static_cast<StartMode>(mode),
                                  .velocity_diff = 150,
                                  .acceleration = 5000,
                                  .jerk = 100000,
                                  .distance = 120});
    const Report report = check(coupling, slave, master(0).master);
    const Engagement in = engage(coupling, slave, master(0).master, 0);
    if (!in) {
      std::printf("%-16s %s\n", name(coupling.spec().start), explain(in.status));
      continue;
    }
    Engaged state = in.engaged;
    double synchronous = 0;
    for (int n = 1; n <= 1400; ++n) {
      const Stepped now = step(coupling, state, master(n * 1e-3));
      if (now.in_sync && synchronous == 0) synchronous = n * 1e-3;
      if (now.periods != 0) std::printf("%16s period ends at %.3f s\n", "", now.end_time);
      state = now.engaged;
    }
    std::printf("%-16s %s: jumps by %g pulses and %g pulse/s, in sync after %.3f s\n",
                name(coupling.spec().start), report.ok() ? "smooth" : "announced", in.jump.position,
                in.jump.velocity, synchronous);
  }
}

// >                  period ends at 1.300 s
// > absolute         announced: jumps by 45 pulses and 200 pulse/s, in sync after 0.001 s
// >                  period ends at 1.300 s
// > relative         announced: jumps by 0 pulses and 200 pulse/s, in sync after 0.001 s
// >                  period ends at 1.300 s
// > ramp_in          smooth: jumps by 0 pulses and 0 pulse/s, in sync after 0.479 s
// >                  period ends at 1.300 s
// > ramp_in_pos      smooth: jumps by 0 pulses and 0 pulse/s, in sync after 0.479 s
// > ramp_in_neg      The slave could reach its cam only against the direction that its start mode allows.
// >                  period ends at 1.300 s
// > ramp_in_distance smooth: jumps by 0 pulses and 0 pulse/s, in sync after 0.600 s
