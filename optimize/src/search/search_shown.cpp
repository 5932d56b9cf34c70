// SPDX-License-Identifier: Apache-2.0
#include "optimize/src/search/search_shown.hpp"

#include <algorithm>
#include <utility>

namespace jounce::optimizer {

Shown shown(Trials& trials, const Choice& z, double hair) {
  const Trial& asked = trials.at(z);
  const Trial& seen = asked.answer.possible ? asked : trials.nearest_possible(z);
  Shown all{seen.answer.objective, {distance(z, seen.z)}};
  if (trials.spread() > 0) all.objective /= trials.spread();
  for (std::size_t i = 0; i < seen.answer.constraints.size(); ++i)
    all.rows.push_back(seen.answer.constraints[i] / trials.scales()[i] + hair);
  return all;
}

std::vector<Shown> slopes(Trials& trials, const Choice& z, double hair, double difference) {
  std::vector<Shown> all;
  for (std::size_t k = 0; k < z.size(); ++k) {
    Choice up = z, down = z;
    up[k] = std::min(1.0, z[k] + difference);
    down[k] = std::max(0.0, z[k] - difference);
    Shown slope = shown(trials, up, hair);
    const Shown low = shown(trials, down, hair);
    const double step = up[k] - down[k];
    slope.objective = (slope.objective - low.objective) / step;
    for (std::size_t i = 0; i < slope.rows.size(); ++i)
      slope.rows[i] = (slope.rows[i] - low.rows[i]) / step;
    all.push_back(std::move(slope));
  }
  return all;
}

}  // namespace jounce::optimizer
