#include "profiles/proof/workloads.hpp"

#include "profiles/proof/judge.hpp"

namespace jounce::proof {
namespace {

std::vector<Workload> listed() {
  std::vector<Workload> list;
  for (const Draw& d : draws()) list.push_back({d.name, d.what, nullptr});
  const Workload own[] = {
      {"optimal", "the minimum duration, against the witness", optimality},
      {"blocks", "durations(), against the witness", blocks},
      {"exact", "durations asked for, inside and at the edges of blocked intervals", exact},
      {"replan-rest", "replanned at a random instant, target at rest", replan_rest},
      {"replan-moving", "replanned at a random instant, any target", replan_moving},
      {"sync-time", "1 to 7 axes that arrive together, against the witness", sync_time},
      {"sync-phase", "2 to 7 axes on one line, against the witness", sync_phase},
      {"invariance", "other units of length and time", invariance},
      {"velocity", "changes of velocity, against the witness", velocity},
      {"walls", "position limits", walls},
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
