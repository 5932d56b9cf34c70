// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <limits>

#include "jounce/profiles/curve/jet.hpp"
#include "jounce/profiles/error.hpp"

namespace jounce {

/// Options of the filter that computes a master from measured positions. Unit m: the unit of the
/// master.
struct TrackerSpec {
  double velocity = 0;      ///< greatest velocity of the master and of the output, m/s, > 0
  double acceleration = 0;  ///< greatest acceleration of the master and of the output, m/s^2, > 0
  /// Time constant, s, > 0: longer is smoother and slower; see docs/executor/masters.md.
  double time_constant = 5e-3;
  int order = 2;  ///< 2: no lag at constant velocity; 3: no lag at constant acceleration
  /// Time in which the output returns to the estimate after a deviation, s, > 0.
  double settle = 10e-3;
  /// Age of each measurement when it arrives, s. The output is extrapolated by this time.
  double latency = 0;
  double longest_age = 0.1;  ///< time without a measurement after which the master is lost, s, > 0
  /// Greatest deviation, m: a measurement further than this from the estimate is a jump, and an
  /// output further than this from the estimate makes the master lost. 0: velocity * longest_age.
  double jump = 0;
  /// Period of the measured position, m: a modulo encoder, whose position repeats after each turn.
  /// The master counts the turns. Between two measurements, the position must deviate from the
  /// extrapolation by less than half a period. 0: the position does not repeat.
  double modulo = 0;
};

/// Throws InputError for a value out of range.
void require_valid(const TrackerSpec& spec);

/// Estimate of position, velocity and acceleration from noisy measurements, by the fading-memory
/// filter: a least-squares fit of a straight line (order 2) or a parabola (order 3). The weight of
/// a measurement falls by the factor exp(-1) in half a time constant (equations (1) to (5) in
/// tracker.cpp). Copies are independent.
struct Estimate {
  double time = 0;             ///< time of the last measurement, s
  double x = 0, v = 0, a = 0;  ///< position, velocity and acceleration at that time: m, m/s, m/s^2
  std::int64_t count = 0;      ///< number of measurements so far

  /// Returns [x, x', x'', 0] at another time, s, by extrapolation.
  [[nodiscard]] Jet at(double t) const;
};

/// Returns the estimate after one more measurement: `measured` (m) at `time` (s), which must be
/// later than the previous one.
Estimate corrected(const Estimate& before, const TrackerSpec& spec, double time, double measured);

/// A smooth master from measured positions. The output follows the estimate, extrapolated to the
/// time of the cycle. For all inputs, its velocity and acceleration are bounded, and its velocity
/// does not jump.
///
///     Tracked master({.velocity = 3, .acceleration = 20});
///     master.see(time, measured);               // as often as something is measured
///     const Jet x = master.at(time);            // each cycle; x[0] is NaN while it is lost
///
/// The master is lost until two measurements have arrived (order 3: three), after `longest_age`
/// without a measurement, and for one cycle after a jump of the measured position. Followers stop
/// in this cycle, so they do not follow the jump. A master that exceeds its limits leaves the
/// output behind. Beyond the distance `jump` the master is lost, until its measured velocity is
/// within the limit again. When the master is valid again, the output begins at its new position.
class Tracked {
 public:
  /// Throws InputError like require_valid().
  explicit Tracked(const TrackerSpec& spec);

  /// Adds the measurement `position`, m, at `time`, s. Ignores values that are not finite, and
  /// times that are not later than the previous one.
  void see(double time, double position) noexcept;
  /// Clears the filter. Call when the source is invalid, or has changed.
  void lose() noexcept;
  /// Returns the master at `time`, s: m, m/s, m/s^2, m/s^3; x[0] is NaN if the master is lost. Call
  /// once in each cycle, with ascending times.
  Jet at(double time) noexcept;

  /// The options.
  [[nodiscard]] const TrackerSpec& spec() const { return spec_; }
  /// The present estimate.
  [[nodiscard]] const Estimate& estimate() const { return estimate_; }
  /// Time of the last measurement, s; it remains after a loss. NaN: no measurement yet.
  [[nodiscard]] double seen() const { return seen_; }
  /// Distance by which the estimate is ahead of the output in the last at(), m; negative: behind.
  /// If the lag was the reason for the loss of the master, it remains during the loss. During any
  /// other loss, it is 0.
  [[nodiscard]] double lag() const { return lag_; }

 private:
  [[nodiscard]] Jet target(double time) const;
  void follow(const Jet& target, double dt);

  TrackerSpec spec_;
  double seen_ = std::numeric_limits<double>::quiet_NaN();
  /// Last measurement, with its turns, m; it remains after a loss.
  double last_ = std::numeric_limits<double>::quiet_NaN();
  Estimate estimate_;
  bool following_ = false;  // the output follows the estimate
  bool outrun_ = false;     // the lag has exceeded the jump, and the master is still too fast
  double lag_ = 0;
  double time_ = 0;  // time of the output
  Jet out_{};
};

}  // namespace jounce
