// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "jounce/path/plan.hpp"

#include "path/src/geometry/route.hpp"
#include "path/src/timing/stations.hpp"

namespace jounce {

/// A route with its corners rounded, and what the law may do on it.
struct Rounded {
  Path path;
  std::vector<Unit> units;
  std::vector<JointMark> joints;
};

/// `stop`: joints at which the plan rests although their corners could be rounded.
Rounded rounded(const Route& route, const Program& program, const Rates& rates,
                const std::vector<bool>& stop);

}  // namespace jounce
