// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "path/src/corners/rounding.hpp"

namespace jounce {

/// A rest of a law: where, and when it begins.
struct Rest {
  std::uint32_t joint = 0;
  double time = 0;
};

struct Laws {
  std::vector<LawStretch> stretches;
  std::vector<Rest> rests;  ///< the start, each stop, and the end
};

/// From rest to rest the faster one of stations and window; dwells between. `times_only`: the rests alone.
Laws fastest_law(Rounded& rounded, const Rates& rates, const Program& program, const Route& route,
                 bool times_only = false);

}  // namespace jounce
