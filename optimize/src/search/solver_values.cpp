// SPDX-License-Identifier: Apache-2.0
#include "optimize/src/search/solver_values.hpp"

#include <algorithm>
#include <utility>

namespace jounce::optimize_detail {

SolverValues solver_values(Evaluations& evaluations, const Choice& z, double margin) {
  const Evaluation& asked = evaluations.at(z);
  const Evaluation& seen = asked.answer.possible ? asked : evaluations.nearest_possible(z);
  SolverValues all{seen.answer.objective, {distance(z, seen.z)}};
  if (evaluations.spread() > 0) all.objective /= evaluations.spread();
  for (std::size_t i = 0; i < seen.answer.constraints.size(); ++i)
    all.rows.push_back(seen.answer.constraints[i] / evaluations.scales()[i] + margin);
  return all;
}

std::vector<SolverValues> slopes(Evaluations& evaluations, const Choice& z, double margin,
                                 double difference) {
  std::vector<SolverValues> all;
  for (std::size_t k = 0; k < z.size(); ++k) {
    Choice up = z, down = z;
    up[k] = std::min(1.0, z[k] + difference);
    down[k] = std::max(0.0, z[k] - difference);
    SolverValues slope = solver_values(evaluations, up, margin);
    const SolverValues low = solver_values(evaluations, down, margin);
    const double step = up[k] - down[k];
    slope.objective = (slope.objective - low.objective) / step;
    for (std::size_t i = 0; i < slope.rows.size(); ++i)
      slope.rows[i] = (slope.rows[i] - low.rows[i]) / step;
    all.push_back(std::move(slope));
  }
  return all;
}

}  // namespace jounce::optimize_detail
