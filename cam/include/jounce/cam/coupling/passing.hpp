// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "jounce/profiles/curve/jet.hpp"

namespace jounce {

/// The master in one cycle. m is the master's unit.
struct Sample {
  double t = 0;  ///< s
  Jet master{};  ///< position (m) and derivatives with respect to time
};

/// Returns the instant at which the master passes a level (m) between two cycles, and its motion at
/// that instant; nullopt if it does not pass. Between the cycles the master follows the cubic
/// through both positions and velocities, which is exact for a constant acceleration or jerk. The
/// level is passed if it lies between the samples, or if the later sample is on it. If the master
/// passes it several times within the cycle, the result is one of these instants.
std::optional<Sample> passing(const Sample& before, const Sample& now, double level);

/// Returns the master at time t (s) between two cycles, by the same cubic.
Sample between(const Sample& before, const Sample& now, double t);

}  // namespace jounce
