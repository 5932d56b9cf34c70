// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <limits>

#include "jounce/profiles/curve/jet.hpp"

namespace jounce {

/// Options of the filter that turns measured positions into a master.
struct TrackerSpec {
  double velocity = 0;      ///< m/s, > 0: limit of the master and of the output
  double acceleration = 0;  ///< m/s^2, > 0: likewise
  double time_constant =
      5e-3;               ///< s, > 0: longer is smoother, and slower. See docs/executor/masters.md
  int order = 2;          ///< 2: no lag at constant velocity; 3: no lag at constant acceleration
  double settle = 10e-3;  ///< s, > 0: time in which the output returns to the estimate
  double latency = 0;     ///< s: additional age of the measurements
  double longest_age = 0.1;  ///< s, > 0: lost after longer without a measurement
  double jump = 0;           ///< m: a measurement further off than this is a jump; 0: the travel at
                             ///< the master's velocity in longest_age
};

/// Throws InputError for a value out of range.
void require_valid(const TrackerSpec& spec);

/// Estimate from noisy measurements: position, velocity and acceleration, by the fading-memory
/// filter: least squares of a straight line (order 2) or a parabola (3), in which a measurement's
/// weight falls by exp(-1) in half a time constant (tracker.cpp (1) to (5)). A value type.
struct Estimate {
  double time = 0;  ///< s, of the last measurement
  double x = 0, v = 0, a = 0;
  std::int64_t count = 0;  ///< measurements so far

  /// [x, x', x'', 0] at another time.
  [[nodiscard]] Jet at(double t) const;
};

/// Returns the estimate with one more measurement, at a later time.
Estimate corrected(const Estimate& before, const TrackerSpec& spec, double time, double measured);

/// A measured position as a smooth master. The output follows the estimate, extrapolated to the
/// cycle, with bounded velocity and acceleration. It is once continuously differentiable for all
/// inputs.
///
///     Tracked master({.velocity = 3, .acceleration = 20});
///     master.see(time, measured);               // as often as something is measured
///     const Jet x = master.at(time);            // each cycle; x[0] is NaN while it is lost
///
/// A master is lost with fewer than two measurements (order 3: three), after longest_age without
/// one, and for one cycle after a jump, so that followers stop instead of chasing it. When it
/// returns, the output begins at its position. In between there is no output, so there is no jump.
class Tracked {
 public:
  explicit Tracked(const TrackerSpec& spec);

  /// Ignores samples that are not finite, or not later than the one before.
  void see(double time, double position) noexcept;
  /// Resets the filter: the source is invalid, or has changed.
  void lose() noexcept;
  Jet at(double time) noexcept;

  [[nodiscard]] const TrackerSpec& spec() const { return spec_; }
  [[nodiscard]] const Estimate& estimate() const { return estimate_; }
  /// s: time of the last measurement; also after a loss. NaN: never.
  [[nodiscard]] double seen() const { return seen_; }

 private:
  [[nodiscard]] Jet target(double time) const;
  void follow(const Jet& target, double dt);

  TrackerSpec spec_;
  double seen_ = std::numeric_limits<double>::quiet_NaN();
  Estimate estimate_;
  bool following_ = false;  // the output follows the estimate
  double time_ = 0;         // time of the output
  Jet out_{};
};

}  // namespace jounce
