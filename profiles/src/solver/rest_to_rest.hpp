// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "jounce/profiles/detail/lanes.hpp"
#include "jounce/profiles/moves/move.hpp"

namespace jounce::profiles_detail {

// From rest to rest, third order, in magnitudes along the way: each half has s = 0 and c = 0
// (extremal.hpp), with p = 1/jp, q = 1/jd, k = p + q. Up to the peak velocity vp a half takes t and
// covers D, which is less than a cruise at vp by E = vp t - D. With its limit L of acceleration,
//
//   (1)  z < L:  vp = k z^2/2,   t = k z,            D = k (k + q) z^3/6,  E = k (k + p) z^3/6
//   (2)  z = L:  t = vp/L + k L/2,  D = vp^2/(2 L) + vp L q/2 - g,  E = vp^2/(2 L) + vp L p/2 + g,
//                g = L^3 (q^2 - p^2)/24
//
// The shortest motion has D + D' = d (or vp = vmax and a cruise). A motion of duration T satisfies
//
//   (3)  vp T - E - E' = d,   the smaller solution: the left side is concave, and grows up to there

/// Solves only this task: both ends at rest, inside the bounds, at different positions.
class RestToRest {
 public:
  RestToRest(double distance, const Bounds& bounds) noexcept;

  /// Returns false if only one half reaches its limit, because that has no closed form.
  bool solve_shortest() noexcept;
  /// Finds the motion that lasts t, longer than the shortest. Returns false also if t is so near to
  /// the shortest duration that (3) almost has a double root.
  bool solve_lasting(double t) noexcept;

  [[nodiscard]] double duration() const noexcept;
  [[nodiscard]] double cruise() const noexcept { return cruise_; }  ///< s
  [[nodiscard]] Profile profile(const MotionState& from, const MotionState& to) const noexcept;

 private:
  void rise_to(double vp) noexcept;
  void pass(double z) noexcept;
  bool pass_in(double t) noexcept;
  bool hold_both(double b, double sign) noexcept;
  [[nodiscard]] Vector2 lost() const noexcept;

  double d_, vmax_;
  double jp_, jd_;  ///< signed
  double p_, q_, k_, twice_per_k_;
  // For both halves:
  Vector2 limit_, per_limit_;
  Vector2 sat_;  ///< vp for which z reaches the limit
  Vector2 z_{}, hold_{}, lasts_{};
  double vp_ = 0, cruise_ = 0;
};

}  // namespace jounce::profiles_detail
