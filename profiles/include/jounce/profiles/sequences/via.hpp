// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "jounce/profiles/curve/curve.hpp"
#include "jounce/profiles/limits/limits.hpp"
#include "jounce/profiles/moves/move.hpp"

namespace jounce {

/// A motion through several points without stopping at them, from rest to rest or from motion to motion.
///
///     const ViaMotion motion = via({.axes = {within(2, 10, 100), within(1, 5, 50)},
///                                   .points = {{0, 0}, {1, 0.5}, {2, 2}}});
///     motion.knots[1].time;                          // s, when all axes pass {1, 0.5}
///     const Motion x = motion.axes[0].at(0.5);
///     motion.duration / motion.stopping_duration;    // gain of not stopping
///
/// **Vocabulary.** A *stretch* is the motion between two neighbouring points; it keeps the bounds of
/// every axis, is jerk-limited if they are, and all axes begin and end it together. It is not a
/// straight line in space. A *turning point* of an axis is one where its next point lies on the
/// other side, or at the same position: the axis has velocity 0 there.
///
/// **Limits of a stretch** hold there in place of the axes' own. **A limit on the norm** of the vector of
/// all axes, which have one unit: over a way d, axis i gets |d_i| / |d| of it, which keeps the norm
/// everywhere and gives it all to a straight way.
struct ViaRates {
  std::vector<double> velocity = {};      ///< u/s, an axis each; empty: 0
  std::vector<double> acceleration = {};  ///< u/s^2, likewise
};

struct ViaSpec {
  std::vector<Bounds> axes;                 ///< limits of each axis
  std::vector<std::vector<double>> points;  ///< u; at least two, one position an axis each
  ViaRates start = {};                      ///< at the first point
  ViaRates end = {};                        ///< at the last one
  std::vector<std::vector<Bounds>> stretches =
      {};  ///< stretches of each, an axis each; empty: `axes`
  /// Velocity, acceleration and jerk of the norm; its position has no limit.
  Limits norm = {};
};

/// The passage of one point.
struct ViaKnot {
  double time = 0;                   ///< s
  std::vector<double> velocity;      ///< u/s, an axis each
  std::vector<double> acceleration;  ///< u/s^2
};

struct ViaMotion {
  std::vector<Trajectory> axes;  ///< one per axis, over the same time from 0; they hold outside
  std::vector<ViaKnot> knots;    ///< one a point
  double duration = 0;           ///< s
  double stopping_duration = 0;  ///< s, of the same motion with a stop at every point between;
                                 ///< infinite if it cannot stop at one
  bool stops = false;            ///< the fall-back: nothing better than stopping was found
};

/// Plans the motion.
///
/// One axis: the shortest motion through the points that does not reverse between points of one
/// direction. Points in one direction cost nothing; the search covers the acceleration at turning
/// points. Several axes: the search covers velocities and accelerations at the points
/// (deterministic, coordinate by coordinate, from a feasible start) and finds a local optimum:
/// never longer than with a stop at every point, not proven to be the shortest. No axis reverses
/// between two points.
///
/// Throws InputError for fewer than two points, a point with another number of axes, one equal to
/// the point before, one that is not finite, greater than 1e30 or outside the position bounds, for
/// bounds that `move_to` rejects, and for rates at an end from which no motion was found that keeps
/// the bounds and does not reverse. Every other input has a motion.
ViaMotion via(const ViaSpec& spec);

}  // namespace jounce
