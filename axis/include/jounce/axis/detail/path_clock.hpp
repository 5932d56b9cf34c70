// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "jounce/axis/axis_config.hpp"
#include "jounce/axis/movement.hpp"

namespace jounce {

/// Path time and its derivatives with respect to the time of the axis. The *rate* is the speed of
/// path time: 1 is the original speed of the path, 0 is rest. It is never negative.
struct PathTime {
  double s = 0;           ///< path time, s
  double rate = 1;        ///< ds/dt
  double rate_slope = 0;  ///< d2s/dt2, 1/s
  double rate_curve = 0;  ///< d3s/dt3, 1/s^2
};

/// The clock of a path. It allows the axis to slow down, hold, stop and speed up without leaving
/// the path.
///
///     PathClock clock(1'000'000);                                // ns of a tick
///     clock.start(tick, 0, 1);                                   // path time 0 now, at full speed
///     double s = clock.at(tick + 500).s;                         // bit for bit 500 * 1e6 / 1e9
///     clock.change(tick + 500, 0, rate_slope(peaks, config, 1)); // a stop
///     while (!clock.steady(tick)) ...                            // the stop takes 1.5 / slope
///     clock.change(tick, 1, slope);                              // continues
///
/// A change of the rate r is the fastest one with |r'| <= slope and |r''| <= 2 slope^2, from any
/// state of a previous change. r' does not jump, and r stays between its start and end values.
/// Rounding errors do not accumulate, because path time is a function of the tick and of the last
/// change. PathClock is a value type; it does not allocate or throw.
class PathClock {
 public:
  /// `period`: duration of a tick, ns.
  explicit PathClock(std::int64_t period) noexcept : period_(period) {}

  /// Sets path time to `s` (s) and the rate, in the given tick.
  void start(std::int64_t tick, double s, double rate) noexcept;
  /// Changes the rate from the given tick on, but not before the tick of the previous change.
  /// `slope` is the greatest |r'|, 1/s. If rate < 0 or slope <= 0, returns false and changes
  /// nothing.
  bool change(std::int64_t tick, double rate, double slope) noexcept;
  /// Shifts the zero of path time: s becomes s - by.
  void shift(double by) noexcept { base_ -= by; }

  /// Returns the path time and its derivatives in the given tick.
  [[nodiscard]] PathTime at(std::int64_t tick) const noexcept;
  /// The rate after the present change.
  [[nodiscard]] double target() const noexcept { return change_.end().velocity; }
  /// Returns an upper bound of the rate from the given tick until the rate is constant.
  [[nodiscard]] double highest(std::int64_t tick) const noexcept;
  /// True if the rate is constant from the given tick on.
  [[nodiscard]] bool steady(std::int64_t tick) const noexcept;
  /// Returns the path time that passes until rest, s. If the change in progress goes to rest, this
  /// change is used; otherwise a change to 0 with the given slope, which begins in the given tick.
  [[nodiscard]] double way_to_rest(std::int64_t tick, double slope) const noexcept;
  /// Returns the path time (s) that passes in three changes, each directly after the previous one:
  /// to `rate`, to full speed, and to rest. Infinite unless slope > 0.
  [[nodiscard]] double way_by(std::int64_t tick, double rate, double slope) const noexcept;

 private:
  [[nodiscard]] double since(std::int64_t tick) const noexcept;

  std::int64_t period_;
  std::int64_t origin_ = 0;
  double base_ = 0;    // path time at origin_, s
  Profile change_;     // present change, from origin_ on: position s, velocity r
  double top_ = 1;     // highest requested rate since the rate was last constant
  double length_ = 0;  // length of the change, s
};

/// Returns the setpoint that the axis outputs at the path time `time.s` and the rate `time.rate`.
/// `path` is the setpoint of the path at rate 1.
Setpoint at_rate(const Setpoint& path, const PathTime& time) noexcept;

/// Returns the highest rate, from 1 to 2, at which an admitted path stays within the limits of the
/// axis.
double highest_rate(const Peaks& peaks, const AxisConfig& config) noexcept;

/// Returns the greatest slope of the rate, 1/s, for rates up to `highest`, with which the axis
/// stays within its stop limits everywhere on the path. `added` has the peaks of a superimposed
/// move. The result is 0 or less if no slope is possible.
double rate_slope(const Peaks& peaks, const AxisConfig& config, double highest,
                  const Peaks& added = {}) noexcept;

/// Returns the duration of a stop from full speed on an admitted path, s: an upper bound everywhere
/// on the path.
double stop_duration(const Peaks& peaks, const AxisConfig& config);

}  // namespace jounce
