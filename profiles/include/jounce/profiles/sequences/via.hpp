// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "jounce/profiles/curve/curve.hpp"
#include "jounce/profiles/limits/limits.hpp"
#include "jounce/profiles/moves/move.hpp"

namespace jounce {

/// A motion of one or more axes through several points without stopping at them. It begins and ends
/// at rest, or at given velocities. u is the unit of an axis.
///
///     const ViaMotion motion = via({.axes = {within(2, 10, 100), within(1, 5, 50)},
///                                   .points = {{0, 0}, {1, 0.5}, {2, 2}}});
///     motion.knots[1].time;                          // s, when all axes pass {1, 0.5}
///     const Motion x = motion.axes[0].at(0.5);
///     motion.stopping_duration - motion.duration;    // s, time saved by not stopping
///
/// **Vocabulary.** A *stretch* is the motion between two successive points. All axes begin and end
/// a stretch together. A stretch stays within the bounds of every axis, and is jerk-limited if the
/// bounds include a jerk. It is not a straight line in space. A *turning point* of an axis is a
/// point after which the axis reverses or keeps its position: its velocity is 0 at this point.
///
/// **Limits of a stretch** replace the limits of the axes in this stretch.
///
/// **Limits of the norm** apply to the length of the vector of all axes, which must have the same
/// unit. In a stretch with the distances d_i and d = sqrt(d_1^2 + d_2^2 + ...), axis i gets the
/// share |d_i| / d of the limit. So the norm stays within the limit everywhere, and a straight path
/// can use the whole limit.

/// Velocities and accelerations of all axes at one end of the motion.
struct ViaRates {
  std::vector<double> velocity = {};      ///< u/s, one for each axis; empty: 0
  std::vector<double> acceleration = {};  ///< u/s^2, one for each axis; empty: 0
};

/// Input of via().
struct ViaSpec {
  std::vector<Bounds> axes = {};  ///< bounds of each axis
  /// u; at least two points, each with one position for each axis.
  std::vector<std::vector<double>> points = {};
  ViaRates start = {};                              ///< at the first point
  ViaRates end = {};                                ///< at the last point
  std::vector<std::vector<Bounds>> stretches = {};  ///< bounds [stretch][axis]; empty: `axes`
  /// Velocity, acceleration and jerk of the norm; its position has no limit.
  Limits norm = {};
};

/// The state in which the axes pass a point.
struct ViaKnot {
  double time = 0;                        ///< s
  std::vector<double> velocity = {};      ///< u/s, one for each axis
  std::vector<double> acceleration = {};  ///< u/s^2, one for each axis
};

/// Result of via().
struct ViaMotion {
  /// One for each axis, over the same time from 0 s; they hold outside.
  std::vector<Trajectory> axes = {};
  std::vector<ViaKnot> knots = {};  ///< one for each point
  double duration = 0;              ///< s
  /// Duration in s of the same motion with a stop at every inner point; infinite if the axes cannot
  /// stop at one of them.
  double stopping_duration = 0;
  bool stops = false;  ///< true if no motion better than stopping at every point was found
};

/// Plans the motion.
/// - One axis: the shortest motion through the points that does not reverse between points that
///   follow each other in one direction. Such points cost no time if the stretches before and after
///   them have the same bounds. To find it, the function varies the acceleration at turning points.
/// - Several axes: a search varies velocities and accelerations at the points, one coordinate at
///   a time, from a feasible start; the result is reproducible. The search finds a local optimum.
///   This motion is never longer than the motion with a stop at every point, but it is not proven
///   to be the shortest. No axis reverses between two points.
///
/// Throws InputError
/// - if there are no axes or fewer than two points;
/// - if a point, a rate or a stretch has the wrong number of axes, or `stretches` the wrong size;
///   if a point equals the previous one, or has a position outside the position bounds; if a
///   position, velocity or acceleration is not finite, or is above 1e30 in magnitude;
/// - for bounds that move_to() rejects; for a bound of the velocity, acceleration or jerk that is
///   not 0, infinite, or from 1e-30 to 1e30 in magnitude; for a limit of the norm that is neither
///   infinite nor from 1e-30 to 1e30, or a limit of its position; and for bounds that do not limit
///   the motion;
/// - if no motion without a reversal was found that starts or ends with the given velocities and
///   stays within the bounds.
///
/// Every other input has a motion.
ViaMotion via(const ViaSpec& spec);

}  // namespace jounce
