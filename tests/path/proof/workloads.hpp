// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "path/proof/draw.hpp"
#include "path/proof/judge.hpp"

namespace jounce::path_proof {

/// Result of one case.
struct Outcome {
  std::string why;   ///< the fault, or ""
  std::string spec;  ///< spec that repeats a failure
};

/// A kind of random programs.
struct Workload {
  std::string name;
  std::string what;
  Outcome (*once)(Random&, Worst&);
  double weight = 100;  ///< share of a total
};

const std::vector<Workload>& workloads();

/// Case `number` of a workload. It depends only on the seed and the number.
Outcome run(const Workload& workload, std::uint64_t seed, std::int64_t number, Worst& worst);

/// The outcome of judging a case.
Outcome outcome(const Case& c, const std::string& why);

Outcome plans_of_lines(Random& r, Worst& worst);
Outcome plans_of_arcs(Random& r, Worst& worst);
Outcome plans_of_curves(Random& r, Worst& worst);
Outcome plans_of_averages(Random& r, Worst& worst);
Outcome plans_of_narrow(Random& r, Worst& worst);
Outcome plans_of_limited(Random& r, Worst& worst);
Outcome twins_of_lines(Random& r, Worst& worst);
Outcome twins_of_arcs(Random& r, Worst& worst);
Outcome twins_of_averages(Random& r, Worst& worst);
Outcome twins_of_limited(Random& r, Worst& worst);
Outcome halves_of_dense(Random& r, Worst& worst);
Outcome flows_of_dense(Random& r, Worst& worst);
Outcome holds(Random& r, Worst& worst);
Outcome overrides(Random& r, Worst& worst);
Outcome retreats(Random& r, Worst& worst);
Outcome flow_of_limited(Random& r, Worst& worst);
Outcome overlaps(Random& r, Worst& worst);
Outcome refinements(Random& r, Worst& worst);

}  // namespace jounce::path_proof
