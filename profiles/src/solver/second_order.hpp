// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "jounce/profiles/moves/move.hpp"

namespace jounce::profiles_detail {

// If the acceleration may step, a motion rises to a peak velocity p, holds it and falls (or is the
// mirror image of that). With rise r and fall f of the velocity, both > 0,
//
//   (1)  t = (p - v0)/r + (p - vf)/f + cruise
//   (2)  d = (p^2 - v0^2)/(2 r) + (p^2 - vf^2)/(2 f) + p cruise
//
// The direct change has p = max(v0, vf) and covers d0. For d > d0, the shortest motion goes up: (2)
// without cruise, or with p = vmax. To last longer than the direct change by `spare`, the motion
// cruises at (d - d0)/spare if that lies between v0 and vf. Otherwise p is above m = max(v0, vf) by
// y. With k = 1/r + 1/f, (1) and (2) then become
//
//   (3)  k y^2/2 - spare y + (d - d0 - m spare) = 0,   the smaller solution; cruise = spare - k y

/// Computes only the shortest motion, for a start and a target inside the bounds. No branch depends
/// on the numbers, because a processor could not predict it.
class ShortestSecondOrder {
 public:
  ShortestSecondOrder(const MotionState& from, const MotionState& to,
                      const Bounds& bounds) noexcept;

  /// The motion begins with the acceleration a for the time t.
  void lead(double t, double a) noexcept;

  [[nodiscard]] double duration() const noexcept { return lead_ + rises_ + cruise_ + falls_; }
  [[nodiscard]] Profile profile(const MotionState& from, const MotionState& to) const noexcept;
  void append(Profile& out) const noexcept;

 private:
  double rise_, fall_;             ///< signed accelerations
  double rises_, cruise_, falls_;  ///< s, durations of the phases
  double lead_ = 0;                ///< s, duration of a first phase with the acceleration fall_
};

/// A change of velocity to the limit, if the velocity exceeds it.
struct Slowed {
  double time, acceleration;
  MotionState state;  ///< state after it
};
Slowed slowed(const MotionState& from, const Bounds& bounds) noexcept;

/// The shortest motion for any velocity at the start.
Profile shortest_second_order(const MotionState& from, const MotionState& to,
                              const Bounds& bounds) noexcept;

/// The counterpart of PointToPoint for an acceleration that may step; the start must be inside the
/// bounds.
class SecondOrder {
 public:
  SecondOrder(const MotionState& from, const MotionState& to, const Bounds& bounds) noexcept;

  void shortest(Profile& out) const noexcept { shortest_.append(out); }
  /// Returns false if the duration, which must be >= minimum(), is blocked.
  bool lasting(double t, Profile& out) const noexcept;
  [[nodiscard]] double minimum() const noexcept { return shortest_.duration(); }
  [[nodiscard]] Durations durations() const noexcept;

 private:
  /// One direction; all values are magnitudes.
  struct Way {
    double sign, v0, vf, vmax, rise, fall, d;

    [[nodiscard]] double natural() const noexcept { return v0 > vf ? v0 : vf; }
    [[nodiscard]] double duration(double peak) const noexcept;
    [[nodiscard]] double distance(double peak) const noexcept;
    /// Equation (3): lasts longer than the direct change by `spare`, and covers `excess` more.
    void append_cruise(double spare, double excess, Profile& out) const noexcept;
  };

  [[nodiscard]] bool is_direct() const noexcept;

  ShortestSecondOrder shortest_;
  Way up_, down_;
  double direct_;  ///< duration of the direct change
  double direct_distance_;
  double rounding_;
};

}  // namespace jounce::profiles_detail
