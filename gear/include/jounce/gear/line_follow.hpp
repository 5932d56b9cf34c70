// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "jounce/profiles/curve/curve.hpp"

namespace jounce {

/// Returns the motion of a slave that starts and stops together with its master, from position
/// `from` to `to` (u). The slave's position is a linear function of the master's: from + (to -
/// from) (x - x0) / (x1 - x0), where x is the master's position and x0, x1 are its positions at the
/// start and end of its motion. u is the slave's unit. Throws InputError "master" if the master
/// ends where it starts, and "from" or "to" if it is not finite.
Trajectory line_follow(const Trajectory& master, double from, double to);

namespace pmc600 {

/// Input of LS_LineFollowAbs and LS_LineFollowRel (PMC600 manual 6.3): two virtual axes on one
/// line. Positions are in pulses. Velocity, acceleration, deceleration and jerk apply to the
/// master.
///
///     const LineFollowed both = line_follow({.end_master = 4000, .end_slave = 2000,
///         .velocity = 2000, .acceleration = 4000, .deceleration = 4000});    // PMC600 example 6.7
struct LineFollow {
  double start_master = 0, start_slave = 0;  ///< pulse, positions at the start
  /// pulse, EndPos[0] and EndPos[1]: positions, or distances if `relative`.
  double end_master = 0, end_slave = 0;
  bool relative = false;     ///< true: LS_LineFollowRel
  double velocity = 0;       ///< pulse/s, > 0
  double acceleration = 0;   ///< pulse/s^2, > 0
  double deceleration = 10;  ///< pulse/s^2, > 0
  /// pulse/s^3, > 0; limits the jerk (the manual calls the profile SIGMOID).
  double jerk = 90000000;
  /// us, > 0; cycle of the controller. It has no effect, because the curves are exact.
  std::int64_t ipo_cycle = 2000;
};

/// The motions of the two axes.
struct LineFollowed {
  Trajectory master, slave;
};

/// Returns the motions of both axes. Throws InputError for a value that is 0 or negative (PMC600
/// error 16#FFFFFFE) or not finite, and "end_master" if the master does not move.
LineFollowed line_follow(const LineFollow& spec);

}  // namespace pmc600
}  // namespace jounce
