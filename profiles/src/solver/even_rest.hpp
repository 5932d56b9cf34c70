// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "jounce/profiles/detail/lanes.hpp"
#include "jounce/profiles/moves/move.hpp"

namespace jounce::profiles_detail {

// From rest to rest over d > 0 with the same limits V, A and J both ways. A ramp up to the peak
// velocity vp takes the times x (rising acceleration), h (held) and x (falling), the ramp down is
// its mirror image, and the cruise lasts c:
//
//   (1)  vp = J x (x + h),   d = vp (2 x + h + c),   T = 4 x + 2 h + c
//
// with x <= A/J, and h > 0 only where x = A/J. The shortest motion cruises at vp = V,
//
//   (2)  x = min(A/J, sqrt(V/J)),   h = V/A - x (or 0),   c = d/V - 2 x - h
//
// if that gives c >= 0. Otherwise c = 0 and
//
//   (3)  x = min(A/J, cbrt(d/(2 J))),   h = -3 x/2 + sqrt(x^2/4 + d/A) (or 0)
//
// The motion of a longer duration T cruises at a lower velocity. Without a hold, x = x0/y with x0 =
// sqrt(d/(J T)) and
//
//   (4)  y^3 - y + u = 0,   u = 2 x0/T,   the greatest y;   u <= 1/sqrt(8), since 4 x <= T
//
// With a hold, vp is the smaller solution of
//
//   (5)  vp^2/A - (T - A/J) vp + d = 0

/// One motion; durations in s.
struct EvenCourse {
  double ramp, hold, cruise;  ///< x, h and c

  [[nodiscard]] double duration() const noexcept { return 4 * ramp + 2 * hold + cruise; }
};

/// A task of Form::even_rest. All cases are computed and one is selected, without a branch that
/// depends on the numbers: a processor cannot predict which limits a move reaches.
class EvenRest {
 public:
  EvenRest() = default;  ///< no task yet
  /// The arguments are magnitudes; velocity and acceleration may be infinite.
  JOUNCE_INLINE EvenRest(double distance, double velocity, double acceleration,
                         double jerk) noexcept
      : d_(distance),
        v_(velocity),
        per_a_(1 / acceleration),
        per_j_(1 / jerk),
        longest_(acceleration * per_j_),
        cubed_(distance / (2 * jerk)),
        per_cubed_(2 * jerk / distance) {}
  JOUNCE_INLINE EvenRest(const MotionState& from, const MotionState& to, const Bounds& b) noexcept
      : EvenRest(std::abs(to.position - from.position),
                 pair(b.velocity_max, -b.velocity_min, to.position < from.position)[0],
                 b.acceleration_max, b.jerk_max) {}

  /// False if d/J is too near to the least or the greatest double.
  [[nodiscard]] JOUNCE_INLINE static bool solves(double distance, double jerk) noexcept {
    return (distance > 1e-290 * jerk) & (distance < 1e290 * jerk);
  }

  [[nodiscard]] JOUNCE_INLINE EvenCourse shortest() const noexcept {
    const Vector2 top = held(square_root(v_ * per_j_), v_ * per_a_ - longest_);
    const double cruise = d_ / v_ - (2 * top[0] + top[1]);
    const double turning = square_root(longest_ * longest_ / 4 + d_ * per_a_) - 1.5 * longest_;
    const Vector2 turn = held(cube_root_in_units(cubed_, per_cubed_), turning);
    const Vector2 course = every<Vector2>(cruise) > 0 ? top : turn;
    return {course[0], course[1], greatest(cruise, 0.0)};
  }

  /// Computes the motion that lasts t; returns false if t is shorter than the shortest duration, or
  /// within rounding of it.
  [[nodiscard]] JOUNCE_INLINE bool lasting(double t, EvenCourse& out) const noexcept {
    const double x0 = square_root(d_ * per_j_ / t);
    const double free = x0 / greatest_root(least(2 * x0 / t, most));
    const double b = t - longest_;
    const double vp = 2 * d_ / (b + square_root(b * b - 4 * d_ * per_a_));
    const Vector2 course = held(free, vp * per_a_ - longest_);
    out = {course[0], course[1], t - 4 * course[0] - 2 * course[1]};
    const double peak_per_j = (course[0] + course[1]) * course[0];
    return (out.cruise > 0) & (peak_per_j <= v_ * per_j_);
  }

 private:
  /// The greatest u in (4); for a greater u, no ramp without a hold lasts t.
  static constexpr double most = 0.354;

  /// x and h: only a ramp that reaches A has a hold, which is given.
  [[nodiscard]] JOUNCE_INLINE Vector2 held(double x, double hold) const noexcept {
    const Vector2 reaches{longest_, greatest(hold, 0.0)};
    return every<Vector2>(x) >= every<Vector2>(longest_) ? reaches : Vector2{x, 0};
  }

  /// The root of (4): a polynomial with an error below 0.003, then two of Halley's steps.
  [[nodiscard]] JOUNCE_INLINE static double greatest_root(double u) noexcept {
    double y = 0.9995985 + u * (-0.4451419 + u * (-1.490506 + u * (6.627067 - u * 15.43185)));
    for (int i = 0; i < 2; ++i) {
      const double f = y * (y * y - 1) + u;
      const double slope = 3 * y * y - 1;
      y -= f * slope / (slope * slope - 3 * y * f);
    }
    return y;
  }

  double d_, v_, per_a_, per_j_;
  double longest_;  ///< A/J, the greatest x
  double cubed_, per_cubed_;
};

/// The motion as a Profile.
[[nodiscard]] JOUNCE_INLINE Profile profile_of(const EvenCourse& c, double jerk,
                                               const MotionState& from,
                                               const MotionState& to) noexcept {
  const double first = std::copysign(jerk, to.position - from.position);
  const Vector2 falls =
      every<Vector2>(c.cruise) > 0 ? every<Vector2>(c.ramp) : Vector2{2 * c.ramp, 0};
  return Profile(from, to, 3, {first, -first},
                 {{c.ramp, 1},
                  {c.hold, 0},
                  {falls[0], 2},
                  {c.cruise, 0},
                  {falls[1], 2},
                  {c.hold, 0},
                  {c.ramp, 1}});
}

/// True if acceleration and jerk have the same limits in both directions, and EvenRest can solve
/// the distance.
[[nodiscard]] JOUNCE_INLINE bool is_even(double distance, const Bounds& b) noexcept {
  return (b.acceleration_max == -b.acceleration_min) & (b.jerk_max == -b.jerk_min) &
         EvenRest::solves(std::abs(distance), b.jerk_max);
}

}  // namespace jounce::profiles_detail
