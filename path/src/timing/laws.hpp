// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "path/src/corners/rounding.hpp"

namespace jounce {

/// A rest of a law: the junction, and the time at which it begins.
struct Rest {
  std::uint32_t joint = 0;
  double time = 0;
};

struct Laws {
  LawStretches stretches;
  std::vector<Rest> rests;  ///< the start, each stop, and the end
};

/// The fastest law: between two rests it is the faster one of stations and window; dwells are
/// added. `times_only`: computes only the rests.
Laws fastest_law(Rounded& rounded, const Rates& rates, const Program& program, const Route& route,
                 bool times_only = false);

/// The stretches of a run of `count` pieces from `first` on, with one phase of constant jerk each.
/// Times and places count from 0.
LawStretches stretches_of(const Path& path, std::size_t first, std::size_t count,
                          std::span<const LawPhase> phases);

/// The times at which a motion that rests at each corner begins the given rests, and its duration.
/// The motion rests at all of them; they ascend. `shapes`: shapes of the junctions.
std::vector<double> stop_times(const Route& route, const Lines& lines, const Program& program,
                               const Rates& rates, std::span<const CornerShape> shapes,
                               std::span<const Rest> at);

}  // namespace jounce
