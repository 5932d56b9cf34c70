// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "jounce/path/law.hpp"

#include "path/src/timing/box.hpp"

namespace jounce {

/// One stretch of a path with one box, for a law of stations.
struct Unit {
  double length = 0;
  Box box;
  double entry = PathSettings::none;  ///< greatest velocity at its start; 0: a rest
  double dwell = 0;                   ///< s, dwell at its start
  std::uint32_t piece = 0, pieces = 1;
  std::uint32_t joint = 0;  ///< the last junction of the route at or before its start
};

/// The fastest stretch over a unit from v0 to v1. The unit must be long enough for it.
LawInterval stretch_of(const Unit& unit, double v0, double v1);

/// The law with stations at the ends of the units, from rest to rest. Times and places count from 0
/// (docs/path/README.md, "Stations").
LawStretches stations(std::vector<Unit> units);

}  // namespace jounce
