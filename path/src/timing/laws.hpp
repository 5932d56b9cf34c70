// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "path/src/corners/rounding.hpp"

namespace jounce {

/// A rest of a law: the junction, and the time at which it begins.
struct Rest {
  std::uint32_t joint = 0;
  double time = 0;
};

struct Laws {
  std::vector<LawInterval> stretches;
  std::vector<Rest> rests;  ///< the start, each stop, and the end
};

/// The fastest law: between two rests it is the faster one of stations and window; dwells are
/// added. `times_only`: computes only the rests.
Laws fastest_law(Rounded& rounded, const Rates& rates, const Program& program, const Route& route,
                 bool times_only = false);

}  // namespace jounce
