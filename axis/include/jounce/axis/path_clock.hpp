// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "jounce/axis/axis_config.hpp"
#include "jounce/axis/movement.hpp"

namespace jounce {

/// Path time and its derivatives by the axis's time. A *rate* of 1 is the path as it was made, 0 is
/// rest; it never is negative.
struct PathTime {
  double s = 0;           ///< s
  double rate = 1;        ///< ds/dt
  double rate_slope = 0;  ///< d2s/dt2, 1/s
  double rate_curve = 0;  ///< d3s/dt3, 1/s^2
};

/// The time of a path that may be slowed down, held, stopped and sped up without being left.
///
///     PathClock clock(1'000'000);                                  // ns of a tick
///     clock.start(tick, 0, 1);                                     // path time 0 now, at full speed
///     double s = clock.at(tick + 500).s;                           // bit for bit 500 * 1e6 / 1e9
///     clock.change(tick + 500, 0, rate_slope(peaks, config, 1));   // a stop
///     while (!clock.steady(tick)) ...                              // it takes 1.5 / slope
///     clock.change(tick, 1, slope);                                // and on
///
/// A change is the fastest one with |r'| <= slope and |r''| <= 2 slope^2, from any state that a change
/// before has come to: r' never leaps, r never leaves the two rates it is between. Nothing
/// accumulates: a time is a function of the tick and of the last change. A value type; nothing
/// allocates or throws.
class PathClock {
 public:
  explicit PathClock(std::int64_t period) noexcept : period_(period) {}

  /// At that tick path time is s, and runs at that rate.
  void start(std::int64_t tick, double s, double rate) noexcept;
  /// From that tick on, or that of the change before, towards another rate. False, and nothing is
  /// changed, unless rate >= 0 and
  /// slope > 0.
  bool change(std::int64_t tick, double rate, double slope) noexcept;
  /// Path time counts from another zero: s becomes s - by.
  void shift(double by) noexcept { base_ -= by; }

  [[nodiscard]] PathTime at(std::int64_t tick) const noexcept;
  [[nodiscard]] double target() const noexcept { return change_.end().velocity; }
  /// No rate above this one comes before the clock is steady.
  [[nodiscard]] double highest(std::int64_t tick) const noexcept;
  [[nodiscard]] bool steady(std::int64_t tick) const noexcept;
  /// The path time that the change under way, or one begun now, still runs through until rest.
  [[nodiscard]] double way_to_rest(std::int64_t tick, double slope) const noexcept;
  /// The same of a run to `rate` first, from there to full speed, and then to rest, each as soon as
  /// the one before is over; infinite where the slope is not > 0.
  [[nodiscard]] double way_by(std::int64_t tick, double rate, double slope) const noexcept;

 private:
  [[nodiscard]] double since(std::int64_t tick) const noexcept;

  std::int64_t period_;
  std::int64_t origin_ = 0;
  double base_ = 0;    // path time at origin_, s
  Profile change_;     // change of path time from there: position s, velocity r
  double top_ = 1;     // the highest rate asked for since it was steady
  double length_ = 0;  // length of the change, s
};

/// A setpoint of the path at path time `time.s`, as the axis gives it out at that rate.
Setpoint at_rate(const Setpoint& path, const PathTime& time) noexcept;

/// The highest rate, at most 2, at which a path keeps the limits of the axis; at least 1.
double highest_rate(const Peaks& peaks, const AxisConfig& config) noexcept;

/// Greatest slope of the rate, 1/s, while it is at most `highest`, so that the stop limits hold
/// wherever on the path that is; `added` moves on top of it. Not > 0 where nothing is left.
double rate_slope(const Peaks& peaks, const AxisConfig& config, double highest,
                  const Peaks& added = {}) noexcept;

/// Duration of a stop from full speed on a path, s: from its peaks, so that it holds wherever
/// the stop comes. For an admitted path only.
double stop_duration(const Peaks& peaks, const AxisConfig& config);

}  // namespace jounce
