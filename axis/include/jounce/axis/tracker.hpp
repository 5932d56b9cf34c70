// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <limits>

#include "jounce/profiles/curve/jet.hpp"

namespace jounce {

/// Options of the filter that makes a master of measured positions.
struct TrackerSpec {
  double velocity = 0;      ///< m/s, > 0: the master's; what comes out never exceeds it
  double acceleration = 0;  ///< m/s^2, > 0: likewise
  double time_constant =
      5e-3;               ///< s, > 0: longer is smoother, and slower. See docs/executor/masters.md
  int order = 2;          ///< 2: no lag at constant velocity; 3: nor at constant acceleration
  double settle = 10e-3;  ///< s, > 0: in which the output comes back to the estimate
  double latency = 0;     ///< s: additional age of the measurements
  double longest_age = 0.1;  ///< s, > 0: without a measurement for longer, it is lost
  double jump = 0;           ///< m: a measurement further off than this is another place; 0: what
                             ///< the master's velocity makes in longest_age
};

/// Throws InputError for a value out of range.
void require_valid(const TrackerSpec& spec);

/// The estimate behind noise: position, velocity and acceleration, by the fading-memory filter: least
/// squares of a straight line (order 2) or a parabola (3), in which a measurement's weight falls by
/// exp(-1) in half a time constant (tracker.cpp (1) to (5)). A value.
struct Estimate {
  double time = 0;  ///< s, of the last measurement
  double x = 0, v = 0, a = 0;
  std::int64_t count = 0;  ///< measurements so far

  /// [x, x', x'', 0] at another time.
  [[nodiscard]] Jet at(double t) const;
};

/// The estimate with one more measurement, at a later time.
Estimate corrected(const Estimate& before, const TrackerSpec& spec, double time, double measured);

/// A measured position as a smooth master: the estimate, extrapolated to the cycle, behind which the
/// output goes with bounded velocity and acceleration: what comes out is once continuously
/// differentiable for all inputs.
///
///     Tracked master({.velocity = 3, .acceleration = 20});
///     master.see(time, measured);               // as often as something is measured
///     const Jet x = master.at(time);            // each cycle; x[0] is NaN while it is lost
///
/// Lost are masters of fewer than two measurements (order 3: three), those last seen longer ago than
/// longest_age, and for one cycle one that has jumped, so that followers stop rather than race after
/// it. When it comes back it begins where it is. In between nothing is given, so nothing jumps.
class Tracked {
 public:
  explicit Tracked(const TrackerSpec& spec);

  /// Ignores samples that are not finite, or not later than the one before.
  void see(double time, double position) noexcept;
  /// Resets the filter: the source is invalid, or another one.
  void lose() noexcept;
  Jet at(double time) noexcept;

  [[nodiscard]] const TrackerSpec& spec() const { return spec_; }
  [[nodiscard]] const Estimate& estimate() const { return estimate_; }
  /// s: when it was seen last; also after it was lost. NaN: never.
  [[nodiscard]] double seen() const { return seen_; }

 private:
  [[nodiscard]] Jet target(double time) const;
  void follow(const Jet& target, double dt);

  TrackerSpec spec_;
  double seen_ = std::numeric_limits<double>::quiet_NaN();
  Estimate estimate_;
  bool following_ = false;  // the output is one
  double time_ = 0;         // time of the output
  Jet out_{};
};

}  // namespace jounce
