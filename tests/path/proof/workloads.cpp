// SPDX-License-Identifier: Apache-2.0
#include "path/proof/workloads.hpp"

#include "jounce/profiles/error.hpp"

namespace jounce::path_proof {

const std::vector<Workload>& workloads() {
  static const std::vector<Workload> list{
      {"lines", "plans of lines", plans_of_lines, 400},
      {"arcs", "plans of lines and arcs", plans_of_arcs, 40},
      {"curves", "plans of lines, arcs and splines, with axes that follow", plans_of_curves, 20},
      {"averages", "plans of averaged short lines", plans_of_averages, 10},
      {"narrow", "lines that nearly coincide, turn back or go straight", plans_of_narrow, 200},
      {"limited", "lines, arcs and averages with limits of axes in each command", plans_of_limited,
       150},
      {"limited-flow", "the same, held, played with an override, or back", flow_of_limited, 30},
      {"twins-limited", "lines with such limits, mirrored, cut, in other units, in exchanged axes",
       twins_of_limited, 60},
      {"twins", "lines: mirrored, cut, in other units, in exchanged axes, rotated", twins_of_lines,
       200},
      {"twins-arcs", "the same with arcs", twins_of_arcs, 20},
      {"twins-averages", "the same with averages", twins_of_averages, 5},
      {"halves", "dense short lines: a plan of all, and two plans with a rest between them",
       halves_of_dense, 10},
      {"dense-flow", "dense short lines: halted and resumed, and played with an override",
       flows_of_dense, 10},
      {"hold", "halted at any instant, and resumed", holds, 60},
      {"override", "played with an override", overrides, 40},
      {"retreat", "back along the path, and on", retreats, 20},
      {"overlap", "lines that overlap in time", overlaps, 40},
      {"refine", "refined timing laws", refinements, 0.2},
  };
  return list;
}

Outcome run(const Workload& workload, std::uint64_t seed, std::int64_t number, Worst& worst) {
  Random random(Random(seed).next() + static_cast<std::uint64_t>(number) * 0x9e3779b97f4a7c15U);
  random.next();
  return workload.once(random, worst);
}

Outcome outcome(const Case& c, const std::string& why) {
  return {why, why.empty() ? std::string() : spec_of(c)};
}

}  // namespace jounce::path_proof
