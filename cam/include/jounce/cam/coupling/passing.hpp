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

/// Returns the instant at which the master passes a level (m) between two cycles, and the motion of
/// the master at that instant; nullopt if the master does not pass the level. Between the cycles,
/// the master follows the cubic through the positions and velocities of both samples, which is
/// exact for a constant acceleration or jerk. The level is passed if it lies between the samples,
/// or if the later sample is on it. If the master passes the level several times within the cycle,
/// the result is one of these instants.
std::optional<Sample> passing(const Sample& before, const Sample& now, double level);

/// Returns the master at time t (s) between two cycles: position and velocity on the cubic of
/// passing(), acceleration and jerk interpolated linearly. At or after the later cycle, returns
/// `now`.
Sample between(const Sample& before, const Sample& now, double t);

}  // namespace jounce
