// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "jounce/profiles/curve/jet.hpp"

namespace jounce {

/// The master at one cycle: its jet at time t, s.
struct Sample {
  double t = 0;
  Jet master{};
};

/// When the master passes a level between two cycles, and how it moves then, by the cubic through
/// both positions and velocities: exact for a master of constant acceleration or jerk. The level is
/// passed where the samples lie on both sides of it, or the later one on it. Of a master that
/// passes more than once within one cycle the answer is one of the times.
std::optional<Sample> passing(const Sample& before, const Sample& now, double level);

/// The master between two cycles, by the same cubic.
Sample between(const Sample& before, const Sample& now, double t);

}  // namespace jounce
