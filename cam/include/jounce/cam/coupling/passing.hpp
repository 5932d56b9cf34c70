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

/// Returns the instant at which the master passes a level between two cycles, and its motion there,
/// by the cubic through both positions and velocities: exact for a master of constant acceleration
/// or jerk. The level is passed if the samples lie on both sides of it, or the later one on it. If
/// the master passes more than once within one cycle, the result is one of the times.
std::optional<Sample> passing(const Sample& before, const Sample& now, double level);

/// The master between two cycles, by the same cubic.
Sample between(const Sample& before, const Sample& now, double t);

}  // namespace jounce
