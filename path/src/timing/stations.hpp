// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "jounce/path/law.hpp"

#include "path/src/timing/box.hpp"

namespace jounce {

/// One stretch of a path under one box, for a law of stations.
struct Unit {
  double length = 0;
  Box box;
  double entry = PathSettings::none;  ///< greatest velocity at its start; 0: a rest
  double dwell = 0;                   ///< s of rest at its start
  std::uint32_t piece = 0, pieces = 1;
  std::uint32_t joint = 0;  ///< of the route, the last one at or before its start
};

/// A rest of a law: where, and when it begins.
struct Rest {
  std::uint32_t joint = 0;
  double time = 0;
};

struct Stations {
  std::vector<LawStretch> stretches;
  std::vector<Rest> rests;  ///< the start, each stop, and the end
};

/// The law with stations at the units' joints (docs/path/README.md, "Stations"). `last_joint` is that of the end.
Stations stations(std::vector<Unit> units, std::uint32_t last_joint, double last_dwell);

}  // namespace jounce
