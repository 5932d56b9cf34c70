// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "jounce/path/group_limits.hpp"
#include "jounce/path/program.hpp"
#include "jounce/profiles/curve/curve.hpp"

namespace jounce {

/// Requests for the overlap of two lines in time.
struct OverlapOptions {
  /// Greatest distance between a corner and the path, u > 0.
  double deviation = std::numeric_limits<double>::infinity();
  /// Share of the ramps that overlap, 0 to 1: 1 is the whole of the shorter one, 0 a stop (PMC600 TMStartVelocity,
  /// TransitionParameter[0]).
  double share = 1;
};

/// Outcome of one corner.
struct OverlapRecord {
  std::int32_t line = 0;  ///< line of the command that begins here
  double time = 0;        ///< s, when the next line begins
  double overlap = 0;     ///< s, for which both lines are under way; 0: a stop
  double deviation = 0;   ///< u, from the corner to the path: exact
  double one_sided = 0;   ///< u, from the path to the two lines: exact
};

struct Overlapped {
  std::vector<Trajectory> axes;  ///< exact: of degree 3
  double duration = 0;           ///< s
  double stop_duration = 0;      ///< s, with a stop at each corner
  std::vector<OverlapRecord> corners;
};

/// Lines that overlap in time: the next one begins before the last one ends, and the axes move by the sum of both
/// (PMC600 manual 7.1, TMStartVelocity). The path in a corner depends on the limits, as on the controller.
///
///     Program square(2);                                     // the square of program.hpp
///     const Overlapped motion = overlapped(square, limits, {.deviation = 1});
///     motion.duration;                                       // 4.349152 s; with stops 4.8 s
///     motion.corners[0].overlap;                             // 0.150283 s
///
/// **Limits** of the axes hold at every instant, by exact extrema of the sums. Two ways are compared, and the faster
/// one is used: lines at their full rates, with the longest overlap that keeps the limits; and lines whose
/// accelerations and jerks are lower, so that their sum keeps the limits for any overlap. The result is never longer
/// than with stops. Limits of the path hold for each line alone.
///
/// Throws InputError for values out of range, and with the line of a command that is not a line or
/// a dwell.
Overlapped overlapped(const Program& program, const GroupLimits& limits,
                      const OverlapOptions& options = {});

}  // namespace jounce
