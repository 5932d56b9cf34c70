// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "jounce/profiles/moves/move.hpp"
#include "jounce/profiles/sequences/override.hpp"

namespace jounce::profiles_detail {

/// One answer to a request: at `begin` the clock leaves its old course and follows `pieces`.
struct ClockRamp {
  double begin = 0;
  double end = 0;
  double factor = 1;  ///< factor after the end
  double path = 0;    ///< path time at the end
  std::vector<Segment> pieces;
};

/// The clock as far as it is determined: `pieces` from the start on, then the factor `rate` without
/// end.
struct Clock {
  double start = 0;   ///< s
  double origin = 0;  ///< path time at the start
  std::vector<Segment> pieces;
  double path = 0;  ///< path time at the end of the pieces
  double rate = 1;

  [[nodiscard]] double end() const;
  /// The clock up to t, which must be after the start, and its state there.
  [[nodiscard]] Trajectory until(double t) const;
  [[nodiscard]] MotionState at(double t) const;
  /// The time at which the clock reaches this path time; infinite if never.
  [[nodiscard]] double reaches(double path_time) const;
  void follow(const ClockRamp& ramp);
};

/// The plan: the axes over path time, and the limits for changes of the clock.
struct Path {
  std::vector<Trajectory> axes;  ///< they hold outside
  std::span<const Limits> limits;
  double acceleration = 0;  ///< nominal acceleration of the clock, 1/s
  double jerk = 0;          ///< nominal jerk of the clock, 1/s^2

  [[nodiscard]] double start() const { return axes.front().start(); }
  [[nodiscard]] double end() const { return axes.front().end(); }
  /// True if all axes stay within their limits over this part of the clock.
  [[nodiscard]] bool allows(const Trajectory& clock) const;
  /// The greatest factor that the path permits from `from` to its end.
  [[nodiscard]] double room(double from) const;
};

/// The answer to one request: of all starts, shapes and steepnesses that are tried, and with which
/// all limits hold, the ramp that ends first; nothing if the motion is over before.
std::optional<ClockRamp> earliest_ramp(const Path& path, const Clock& clock,
                                       const FactorRequest& request, double maximum);

}  // namespace jounce::profiles_detail
