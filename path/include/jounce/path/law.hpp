// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "jounce/profiles/curve/curve.hpp"

namespace jounce {

/// One stretch of a timing law; q is the path parameter. docs/path/README.md describes the two
/// kinds of laws.
/// - In a station law, a stretch is a ramp from v0 to a peak, a cruise at the peak, and a ramp to
///   v1. The acceleration is zero at both ends of the stretch.
/// - In a window law, it is one phase of constant jerk, which begins with v0 and `acceleration`
///   (signed).
/// - A rest (dwell) has length 0 and velocity 0.
struct LawInterval {
  double time = 0;                  ///< s, at its start
  double start = 0;                 ///< q at its start
  double length = 0;                ///< in q
  double v0 = 0, peak = 0, v1 = 0;  ///< q/s: at the start, greatest, at the end
  /// q/s^2, > 0, of the first and of the last ramp. In a window law: the acceleration at the start,
  /// signed, and 0.
  double acceleration = 0, deceleration = 0;
  double jerk = 0;           ///< q/s^3, > 0; signed in a window law
  double duration = 0;       ///< s
  std::uint32_t piece = 0;   ///< index of its first piece of the path
  std::uint32_t pieces = 0;  ///< number of pieces; 0: a rest

  /// True for a phase of constant jerk (window law).
  [[nodiscard]] bool is_phase() const { return pieces > 0 && deceleration == 0; }
};

/// A phase of constant jerk.
struct LawPhase {
  double duration = 0;  ///< s
  double position = 0, velocity = 0, acceleration = 0,
         jerk = 0;  ///< at its start: q from the start of the stretch, q/s, q/s^2, q/s^3
};

/// A timing law: q as a function of time. Piecewise cubic, with continuous acceleration; 92 bytes
/// for each stretch.
class TimingLaw {
 public:
  explicit TimingLaw(std::vector<LawInterval> stretches);

  [[nodiscard]] double duration() const;  ///< s
  [[nodiscard]] std::span<const LawInterval> stretches() const { return stretches_; }
  /// Returns q and its derivatives at time t (s) in [0, duration()].
  [[nodiscard]] Motion at(double t) const;
  [[nodiscard]] std::size_t stretch_at(double t) const;  ///< index of the stretch at time t, s
  /// Returns q as a curve over time.
  [[nodiscard]] Trajectory curve() const;

 private:
  [[nodiscard]] std::size_t part_at(double t, std::size_t parts) const;

  std::vector<LawInterval> stretches_;
  /// The duration in equal parts: the number of stretches that begin before each part, and before
  /// the end.
  std::vector<std::uint32_t> before_;
  double parts_per_second_ = 0;
};

/// Writes the phases of a stretch to `out` and returns their number, at most seven. Every phase has
/// a duration.
std::size_t phases(const LawInterval& stretch, std::span<LawPhase, 7> out);

}  // namespace jounce
