// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "jounce/path/group_limits.hpp"
#include "jounce/path/program.hpp"
#include "jounce/profiles/curve/curve.hpp"

namespace jounce {

/// Options of overlapped(). u is the axes' unit of length.
struct OverlapOptions {
  /// Greatest permitted distance between a corner and the path, u, > 0; default: no limit.
  double deviation = std::numeric_limits<double>::infinity();
  /// Share of the ramps that overlap, 0 to 1. 1: the whole of the shorter ramp; 0: a stop at the
  /// corner (PMC600 TMStartVelocity, TransitionParameter[0]).
  double share = 1;
};

/// Result for one corner.
struct OverlapRecord {
  std::int32_t line = 0;  ///< source line of the command that begins at the corner
  double time = 0;        ///< s, start of the next line
  double overlap = 0;     ///< s, time during which both lines move; 0: a stop
  double deviation = 0;   ///< u, exact distance from the corner to the path
  /// u, exact greatest distance from the path to the nearer of the two lines.
  double one_sided = 0;
};

/// Result of overlapped().
struct Overlapped {
  std::vector<Trajectory> axes = {};        ///< one for each axis; exact, of degree 3
  double duration = 0;                      ///< s
  double stop_duration = 0;                 ///< s, duration of the same motion with a stop at each
                                            ///< corner
  std::vector<OverlapRecord> corners = {};  ///< one for each corner
};

/// Plans lines that overlap in time: each line begins before the previous one ends, and the axes
/// move by the sum of the two motions (PMC600 manual 7.1, TMStartVelocity). The limits determine
/// the shape of the path in a corner, as on the controller.
///
///     Program square(2);                                     // the square of program.hpp
///     const Overlapped motion = overlapped(square, limits, {.deviation = 1});
///     motion.duration;                                       // 4.349152 s; with stops 4.8 s
///     motion.corners[0].overlap;                             // 0.150283 s
///
/// **Limits** of the axes apply at every instant, to the exact extrema of the sums. The function
/// plans by two methods and returns the faster result. In the first method, each line has its full
/// velocity, acceleration and jerk, and the overlap is the longest that the limits permit. In the
/// second, accelerations and jerks are reduced so that the sum of two lines stays within the limits
/// for every overlap. The result never takes longer than stop_duration. Limits of the path apply to
/// each line separately.
///
/// Throws InputError for values out of range, and with the source line for a command that is
/// neither a line nor a dwell.
Overlapped overlapped(const Program& program, const GroupLimits& limits,
                      const OverlapOptions& options = {});

}  // namespace jounce
