// SPDX-License-Identifier: Apache-2.0
#include "profiles/proof/workloads.hpp"

#include "profiles/proof/judge.hpp"

namespace jounce::proof {
namespace {

std::vector<Workload> listed() {
  std::vector<Workload> list;
  for (const Draw& d : draws()) list.push_back({d.name, d.what, nullptr, 100});
  const Workload own[] = {
      {"optimal", "the minimum duration, against the witness", optimality, 10},
      {"blocks", "durations(), against the witness", blocks, 10},
      {"exact", "durations asked for, inside and at the edges of blocked intervals", exact, 10},
      {"replan-rest", "replanned at a random instant, target at rest", replan_rest, 100},
      {"replan-moving", "replanned at a random instant, any target", replan_moving, 100},
      {"optimal-unequal", "as optimal, limits far apart from each other", optimality_unequal, 10},
      {"blocks-unequal", "as blocks, limits far apart from each other", blocks_unequal, 10},
      {"exact-unequal", "as exact, limits far apart from each other", exact_unequal, 10},
      {"replan-unequal", "replanned at a random instant, limits far apart from each other",
       replan_unequal, 100},
      {"sync-time", "1 to 7 axes that arrive together, against the witness", sync_time, 5},
      {"sync-phase", "2 to 7 axes on one line, against the witness", sync_phase, 10},
      {"invariance", "other units of length and time", invariance, 100},
      {"velocity", "changes of velocity, against the witness", velocity, 100},
      {"stops", "stops of any start, against integrated ones", stops, 100},
      {"overshoot",
       "limits lowered in motion: what can stop in front of its target does not pass it", overshoot,
       300},
      {"relations", "mirrored, backwards in time, wider limits, by way of another state", relations,
       50},
      {"driven", "motions made by integration: their durations are possible", driven_one, 50},
      {"driven-axes", "axes that all have a motion of one duration", driven_together, 20},
      {"certified", "no shorter move, and blocked intervals, by duality", certified, 0.02},
      {"certified-v", "no faster change of velocity, by duality", certified_velocity, 0.02},
      {"walls", "position limits", walls, 30},
  };
  list.insert(list.end(), std::begin(own), std::end(own));
  return list;
}

}  // namespace

const std::vector<Workload>& workloads() {
  static const std::vector<Workload> list = listed();
  return list;
}

Tally run(const Workload& workload, std::int64_t count, std::uint64_t seed, std::size_t kept) {
  Tally tally;
  tally.kept = kept;
  Random random(seed);
  while (tally.cases < count) {
    if (workload.once)
      workload.once(random, tally);
    else
      solve(draw(workload.name.c_str(), random), tally);
  }
  return tally;
}

}  // namespace jounce::proof
