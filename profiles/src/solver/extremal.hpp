// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>

#include "jounce/profiles/detail/lanes.hpp"

namespace jounce::profiles_detail {

// Extremals: the motions that go farthest in a given time with limited jerk. The general solver is
// based on them. docs/generators/move.md has the detailed derivation.
//
// Fix both ends, (v0, a0) and (vf, af), and a duration T. The bounds on velocity, acceleration and
// jerk are convex, so the distances that can be covered in T form an interval [Dmin(T), Dmax(T)].
// The motion that attains Dmax is an *extremal*:
//
//   jerk   +  0  -  (cruise)  -  0  +     acceleration a0 -> z1, held, -> 0 -> -z2, held, -> af
//
// The second half, run backwards, begins at (vf, -af) and has the same form as the first. Consider
// a half that begins at velocity v and acceleration s and leads to the peak velocity vp. With c =
// v - s^2/(2 jp), k = 1/jp + 1/jd, and jp, jd > 0 the jerks of the rise and the fall of the
// acceleration,
//
//   (1)  vp = c + k z^2/2 + z h                            z: its peak acceleration, h: time held
//   (2)  t  = (z - s)/jp + h + z/jd
//   (3)  d  = c (z - s)/jp + (z^3 - s^3)/(6 jp^2) + (c + z^2/(2 jp)) h + z h^2/2
//             + vp z/jd - z^3/(6 jd^2)
//
// If the acceleration has the same sign from z1 to -z2, one z is negative; the halves then overlap,
// and (1) to (3) still hold. Along the family, in the direction of growing T,
//
//   (4)  dDmax/dT = H = vp + z1 z2/(2 jd)
//
// Dmin is Dmax of the motion mirrored in position.
//
// If one jerk is far below the other, c or vp may be far from every velocity of the motion, and a
// phase of seconds changes z by less than its last digits. The same equations, written in the
// durations of the phases, keep their digits (extremal_timed.cpp).

/// If the ratio between the two jerks or the two accelerations is at least this, the digits that
/// (1) to (3) lose matter.
inline constexpr double uneven = 8;

/// A member of the family.
struct Extremal {
  // The first and the second half, one in each lane:
  Vector2 z{};     ///< peak accelerations towards the peak velocity
  Vector2 rise{};  ///< s, duration of the rise of the acceleration to z
  Vector2 hold{};  ///< s, duration for which the acceleration is z
  /// s, duration of the fall of the acceleration from z1 to -z2, without the cruise.
  double fall = 0;
  double vp = 0;      ///< peak velocity
  double cruise = 0;  ///< s, duration of the cruise at the peak velocity
};

/// All extremals between two ends. If the accelerations at both ends have the same sign, there may
/// be two separate branches. In the *early* branch the velocity changes without a zero of the
/// acceleration; it extends from its direct change to a longest member. The *main* branch extends
/// from its direct change to any duration.
class Extremals {
 public:
  struct End {
    double velocity;
    double acceleration;
  };
  /// Magnitudes, all > 0; may be infinite.
  struct Limits {
    double velocity;    ///< upwards
    double rise, fall;  ///< acceleration upwards and downwards
  };
  /// Magnitudes, all > 0: 1/jp, 1/jd, their sum k, and 1/k.
  struct Jerks {
    double per_rise, per_fall, k, per_k;

    [[nodiscard]] Jerks mirrored() const noexcept { return {per_fall, per_rise, k, per_k}; }
  };
  enum class Branch { early, main };

  /// `degenerate` is the half (0 or 1) with the greater natural velocity. The natural velocity is
  /// the velocity at which the acceleration reaches zero if it returns to zero at once. `dv` is the
  /// velocity of `to` minus the velocity of `from`; it may be more exact than both.
  Extremals(const End& from, const End& to, double dv, const Limits& limits, const Jerks& jerks,
            int degenerate) noexcept;

  /// True if there is an early branch, to the rounding of the velocities.
  [[nodiscard]] bool has_early() const noexcept;
  /// The shortest member of a branch, and the longest member of the early branch.
  [[nodiscard]] Extremal first(Branch b) const noexcept;
  [[nodiscard]] Extremal last_early() const noexcept;
  /// The shortest member of the main branch (the direct change of velocity), as a member of the
  /// mirrored family.
  [[nodiscard]] Extremal mirrored(const Extremal& direct) const noexcept;

  [[nodiscard]] double duration(const Extremal& e) const noexcept {
    return e.rise[0] + e.hold[0] + e.fall + e.cruise + e.hold[1] + e.rise[1];
  }
  [[nodiscard]] double distance(const Extremal& e) const noexcept;
  /// The durations of the seven phases, with jerk + 0 - 0 - 0 +. The duration of a phase that does
  /// not occur may be negative by rounding.
  [[nodiscard]] std::array<double, 7> phases(const Extremal& e) const noexcept;
  /// Equation (4).
  [[nodiscard]] double slope(const Extremal& e) const noexcept {
    return e.vp + e.z[0] * e.z[1] * ijd_ / 2;
  }

  /// The members of the branch that cover d, by ascending duration: at most three.
  using Members = std::array<Extremal, 3>;
  [[nodiscard]] int covering(Branch b, double d, Members& out, int most = 3) const noexcept;
  /// The shortest of them on the main branch, by a faster method. d >= covered, which is the
  /// distance of `begin` = first(Branch::main).
  [[nodiscard]] Extremal cover(double d, const Extremal& begin, double covered) const noexcept;
  /// The member of the branch that lasts t.
  [[nodiscard]] Extremal lasting(Branch b, double t) const noexcept;

  /// The greater of the natural velocities of both ends.
  [[nodiscard]] double natural() const noexcept { return natural_; }
  /// Two motions that are not extremal but have the same form. One cruises at the natural velocity.
  /// The other one cruises at a higher velocity and covers d in t. Call the latter only for t and d
  /// that permit the former; it returns false if no velocity covers d, within `slack`.
  [[nodiscard]] Extremal level() const noexcept { return at_peak(natural_); }
  bool cruising(double t, double d, double slack, Extremal& out) const noexcept;
  /// The same by a faster method; returns false also if its few steps do not find the motion.
  bool soon_cruising(double t, double d, Extremal& out) const noexcept;

 private:
  template <class Real>
  struct Half {
    Real v, s, limit, c;
    Real gain;     ///< from v to natural
    Real to_sat;   ///< from natural to sat
    Real sat;      ///< vp for which z reaches the limit
    Real natural;  ///< vp for which z is the greater of s and 0
  };
  /// Both halves, one in each lane.
  struct Halves : Half<Vector2> {
    [[nodiscard]] Half<double> operator[](std::size_t i) const noexcept {
      return {v[i], s[i], limit[i], c[i], gain[i], to_sat[i], sat[i], natural[i]};
    }
  };
  /// A stretch of a branch on which the same halves hold their limit. It has one parameter.
  struct Stretch {
    enum class Held { none, one, both, cruise } held;
    int free;  ///< for Held::one: the half that does not hold
    double lo, hi;
  };
  using Stretches = std::array<Stretch, 6>;

  [[nodiscard]] int stretches(Branch b, Stretches& out) const noexcept;
  [[nodiscard]] Extremal member(const Stretch& p, double x) const noexcept;
  [[nodiscard]] int turning(const Stretch& p, std::array<double, 2>& out) const noexcept;
  [[nodiscard]] Extremal solve(const Stretch& p, double d, bool rising,
                               double guess) const noexcept;
  [[nodiscard]] double solve_sum(double g, double lo, double hi, bool rising,
                                 double guess) const noexcept;
  /// Equation (5) without K, divided by k, as a function of the sum of both z.
  [[nodiscard]] double of_sum(double s) const noexcept {
    return s * (mean_ + cubic_ * s * s) - (s > 0 ? inverse_ / s : 0);
  }
  [[nodiscard]] double cruise_velocity(double t, double d) const noexcept;
  [[nodiscard]] Extremal cruising_above(double above, double t) const noexcept;
  double cruising_step(const Extremal& e, double d, double& sign) const noexcept;
  /// `beyond`: a small part of the peak velocity that rounding of vp + beyond would lose.
  [[nodiscard]] Extremal at_peak(double vp, double beyond = 0) const noexcept;
  /// The duration for which the other half holds its limit if the half `free` has z. Computed from
  /// the difference between the c of both halves, because velocities have too few digits.
  [[nodiscard]] double held_beside(int free, double z) const noexcept {
    const double l = half_[static_cast<std::size_t>(1 - free)].limit;
    return k_ / 2 * ((free == high_ ? q_ : -q_) + (z - l) * (z + l)) / l;
  }
  [[nodiscard]] Extremal beginning(int which, double sign) const noexcept;
  /// The duration in which a half reaches z. If z and s are nearly equal, z^2 - s^2 is more exact
  /// than z.
  [[nodiscard]] double rise(const Half<double>& h, double z, double squares) const noexcept {
    return (rises_slowly_ && z * h.s > 0 ? squares / (z + h.s) : z - h.s) * ijp_;
  }

  // Uses the time of a slow phase as parameter: the time of both rises, of the rise of the free half,
  // or of the fall.
  [[nodiscard]] bool is_timed(const Stretch& p) const noexcept;
  [[nodiscard]] Extremal timed(const Stretch& p, double x) const noexcept;
  [[nodiscard]] Extremal timed_none(double x) const noexcept;
  [[nodiscard]] Extremal timed_one(int free, double x) const noexcept;
  [[nodiscard]] double time_of(const Stretch& p, double z) const noexcept;
  [[nodiscard]] double time_lasting(const Stretch& p, double t) const noexcept;
  [[nodiscard]] Extremal solve_time(const Stretch& p, double d, bool rising) const noexcept;

  Halves half_;
  double vmax_, dv_, ijp_, ijd_, k_, ik_;  ///< ijp_ = 1/jp, ik_ = 1/k
  /// Difference between the velocities of the first and the second half at which the accelerations
  /// are zero.
  double excess_;
  bool rises_slowly_;  ///< jp is far below jd
  double natural_;
  double mean_, cubic_, inverse_, base_;  ///< coefficients of (5): m, (k + 1/jd)/24, q^2/(8 jp), K
  double q_;                              ///< z_low^2 - z_high^2, while no half holds
  int high_;   ///< the half with the greater c; its z is the smaller one while no half holds
  int first_;  ///< the half that is degenerate at the start of the main branch
};

}  // namespace jounce::profiles_detail
