// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "jounce/axis/axis_config.hpp"
#include "jounce/axis/movement.hpp"

namespace jounce {

/// Path time and its derivatives with respect to the axis's time. A *rate* of 1 is the original
/// speed of the path, 0 is rest; it is never negative.
struct PathTime {
  double s = 0;           ///< s
  double rate = 1;        ///< ds/dt
  double rate_slope = 0;  ///< d2s/dt2, 1/s
  double rate_curve = 0;  ///< d3s/dt3, 1/s^2
};

/// The time of a path. It lets the axis slow down, hold, stop and speed up without leaving the
/// path.
///
///     PathClock clock(1'000'000);                                // ns of a tick
///     clock.start(tick, 0, 1);                                   // path time 0 now, at full speed
///     double s = clock.at(tick + 500).s;                         // bit for bit 500 * 1e6 / 1e9
///     clock.change(tick + 500, 0, rate_slope(peaks, config, 1)); // a stop
///     while (!clock.steady(tick)) ...                            // it takes 1.5 / slope
///     clock.change(tick, 1, slope);                              // and on
///
/// A change is the fastest one with |r'| <= slope and |r''| <= 2 slope^2, from any state that a
/// previous change has reached: r' has no jump, and r stays between the start and end rates.
/// Nothing accumulates: a time is a function of the tick and of the last change. A value type;
/// nothing allocates or throws.
class PathClock {
 public:
  explicit PathClock(std::int64_t period) noexcept : period_(period) {}

  /// Sets path time to s, at that rate, in that tick.
  void start(std::int64_t tick, double s, double rate) noexcept;
  /// Changes to another rate from that tick on, or from that of the previous change. Returns false
  /// and changes nothing unless rate >= 0 and slope > 0.
  bool change(std::int64_t tick, double rate, double slope) noexcept;
  /// Shifts the zero of path time: s becomes s - by.
  void shift(double by) noexcept { base_ -= by; }

  [[nodiscard]] PathTime at(std::int64_t tick) const noexcept;
  [[nodiscard]] double target() const noexcept { return change_.end().velocity; }
  /// Upper bound of the rate until the clock is steady.
  [[nodiscard]] double highest(std::int64_t tick) const noexcept;
  [[nodiscard]] bool steady(std::int64_t tick) const noexcept;
  /// Remaining path time until rest, by the change in progress or by one that begins now.
  [[nodiscard]] double way_to_rest(std::int64_t tick, double slope) const noexcept;
  /// The same for a run to `rate`, then to full speed, then to rest, each directly after the
  /// previous one; infinite unless the slope is > 0.
  [[nodiscard]] double way_by(std::int64_t tick, double rate, double slope) const noexcept;

 private:
  [[nodiscard]] double since(std::int64_t tick) const noexcept;

  std::int64_t period_;
  std::int64_t origin_ = 0;
  double base_ = 0;    // path time at origin_, s
  Profile change_;     // change of path time from there: position s, velocity r
  double top_ = 1;     // the highest requested rate since it was steady
  double length_ = 0;  // length of the change, s
};

/// Returns the setpoint of the path at path time `time.s`, as the axis outputs it at that rate.
Setpoint at_rate(const Setpoint& path, const PathTime& time) noexcept;

/// The highest rate, at most 2, at which a path keeps the limits of the axis; at least 1.
double highest_rate(const Peaks& peaks, const AxisConfig& config) noexcept;

/// Returns the greatest slope of the rate, 1/s, for rates up to `highest`, that keeps the stop
/// limits everywhere on the path; `added` moves on top of it. Not > 0 if no slope is left.
double rate_slope(const Peaks& peaks, const AxisConfig& config, double highest,
                  const Peaks& added = {}) noexcept;

/// Duration of a stop from full speed on a path, s, from its peaks: an upper bound everywhere on
/// the path. For an admitted path only.
double stop_duration(const Peaks& peaks, const AxisConfig& config);

}  // namespace jounce
