// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "jounce/profiles/curve/curve.hpp"

namespace jounce {

/// One stretch of a timing law. Of a law of stations: from v0 by a ramp to a peak, along at the peak, by a ramp to
/// v1, with acceleration zero at both ends. Of a law of a window: one phase of constant jerk, from v0 and
/// `acceleration` (signed). A rest (dwell) has length 0 and velocity 0.
struct LawStretch {
  double time = 0;                            ///< s, start
  double start = 0;                           ///< q, start
  double length = 0;                          ///< in q
  double v0 = 0, peak = 0, v1 = 0;            ///< q/s
  double acceleration = 0, deceleration = 0;  ///< q/s^2 of the two ramps, > 0
  double jerk = 0;                            ///< q/s^3, > 0
  double duration = 0;                        ///< s
  bool single_phase = false;
  std::uint32_t piece = 0;   ///< first piece of the path
  std::uint32_t pieces = 0;  ///< number of pieces; 0: a rest
};

/// Phase of a law: constant jerk.
struct LawPhase {
  double duration = 0;
  double position = 0, velocity = 0, acceleration = 0,
         jerk = 0;  ///< at its start; position within the stretch
};

/// A timing law q(t): piecewise cubic, acceleration continuous. 97 bytes a stretch.
class TimingLaw {
 public:
  explicit TimingLaw(std::vector<LawStretch> stretches);

  [[nodiscard]] double duration() const;
  [[nodiscard]] std::span<const LawStretch> stretches() const { return stretches_; }
  /// q and its derivatives at t in [0, duration()].
  [[nodiscard]] Motion at(double t) const;
  [[nodiscard]] std::size_t stretch_at(double t) const;
  /// The law as a curve.
  [[nodiscard]] Trajectory curve() const;

 private:
  [[nodiscard]] std::size_t part_at(double t, std::size_t parts) const;

  std::vector<LawStretch> stretches_;
  /// The duration in equal parts: the number of stretches that begin before each part, and before the end.
  std::vector<std::uint32_t> before_;
  double parts_per_second_ = 0;
};

/// The phases of a stretch, at most seven, none empty; returns their number.
std::size_t phases(const LawStretch& stretch, std::span<LawPhase, 7> out);

}  // namespace jounce
