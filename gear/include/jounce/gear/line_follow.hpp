// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "jounce/profiles/curve/curve.hpp"

namespace jounce {

/// A slave that moves with its master on one line: slave = from + (to - from) (x - x0) / (x1 - x0),
/// x0 and x1 the master's positions at the begin and end of its motion. So both start and stop
/// together, and the slave's whole motion is the master's, scaled by the ratio of their distances.
/// Throws InputError "master" if the master ends at its start.
Trajectory line_follow(const Trajectory& master, double from, double to);

namespace pmc600 {

/// LS_LineFollowAbs and LS_LineFollowRel (PMC600 manual 6.3): two virtual axes on one line.
/// Positions are in pulses; velocity, acceleration, deceleration and jerk are the master's.
///
///     const LineFollowed both = line_follow({.end_master = 4000, .end_slave = 2000,
///         .velocity = 2000, .acceleration = 4000, .deceleration = 4000});      // example 6.7
struct LineFollow {
  double start_master = 0, start_slave = 0;  ///< positions of the axes
  double end_master = 0, end_slave = 0;      ///< EndPos[0], EndPos[1]: positions, or with
  bool relative = false;                     ///< LS_LineFollowRel: distances
  double velocity = 0;                       ///< > 0
  double acceleration = 0;                   ///< > 0
  double deceleration = 10;                  ///< > 0
  double jerk = 90000000;                    ///< > 0: SIGMOID, taken for the jerk-limited S-curve
  std::int64_t ipo_cycle = 2000;             ///< us, > 0; of the controller, the curves are exact
};

struct LineFollowed {
  Trajectory master, slave;
};

/// Throws InputError for a value that is 0 or negative (16#FFFFFFE) or not finite, and "end_master"
/// if the master has no distance to move.
LineFollowed line_follow(const LineFollow& spec);

}  // namespace pmc600
}  // namespace jounce
