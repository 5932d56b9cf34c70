// SPDX-License-Identifier: Apache-2.0
// Time tables as controllers play them: Googol's PT, PMC600's profiles, and what is odd about a table.
#include <cstdio>

#include "jounce/profiles/curve/extrema.hpp"
#include "jounce/pvt/profile_table.hpp"
#include "jounce/pvt/pt.hpp"
#include "jounce/pvt/table.hpp"
#include "jounce/pvt/warnings.hpp"

using namespace jounce;

int main() {
  // Equal increments from rest: the velocity is not what it looks like.
  const std::vector<PtPoint> points{{10, 10}, {20, 20}, {30, 30}, {40, 40}, {50, 45, PtType::stop}};
  for (const PtRate& rate : pt_rates<OverTime>(points))
    std::printf("from %g to %g\n", rate.start, rate.end);
  for (const Finding& f : check_pt<OverTime>(points, 0, Extrapolation::hold).findings)
    std::printf("%s: %g at %g\n", f.rule.text().c_str(), f.value, f.where);

  const pmc600::ProfileTable stages{.points = {{1, 10000}, {2, 40000}, {1, -10000}, {0.5, -5000}},
                                    .is_absolute = false};
  const Trajectory profile = pmc600::position_profile(stages);
  std::printf("%g s, to %g, fastest %.0f\n", profile.end(), profile.at(profile.end()).position,
              extrema(profile, 1).max.value);

  const Table hmpl(Domain::time, Interpolation::cubic_hermite, Extrapolation::hold,
                   {{0, 2, 3}, {0, 153.333, 42.123}, {0, 1000, 800}, {}});
  for (const Finding& f : overshoot(hmpl.curve<OverTime>()).findings)
    std::printf("segment %zu: %.1f, beyond %g\n", *f.segment + 1, f.value, f.limit);
}

// > from 0 to 2
// > from 2 to 0
// > from 0 to 2
// > from 2 to 0
// > from 1 to 0
// > pt/oscillation: 2 at 10
// > pt/velocity_step: 1 at 40
// > 4.5 s, to 35000, fastest 27293
// > segment 1: -188.7, beyond 0
// > segment 2: 244.2, beyond 153.333
