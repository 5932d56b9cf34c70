// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "jounce/profiles/detail/tolerances.hpp"
#include "jounce/profiles/moves/profile.hpp"

// A move of two velocity ramps with a cruise between them, v0 -> peak -> v1. The acceleration is
// zero where they meet. A law gives the shape of a ramp whose velocity changes by dv >= 0. The
// second ramp is a ramp from v1 to the peak, run backwards in time. A ramp from v (or, run
// backwards, to v) covers
//
//   (1)  D(v, dv) = v T(dv) + W(dv),   W = integral of (T - t) a(t) dt
//
// where T is its duration and a(t) its acceleration. D grows with dv. In a move over the distance h
// without cruise, the peak velocity p solves
//
//   (2)  D(v0, p - v0) + D(v1, p - v1) = h,   each D under its own law.

namespace jounce::profiles_detail {

/// The acceleration of a ramp: linear from `begin` to `peak` during `rise`, constant during `hold`,
/// linear to zero during `fall`. Units: u/s^2 and s.
struct RampShape {
  double begin = 0;
  double peak = 0;
  double rise = 0;
  double hold = 0;
  double fall = 0;

  [[nodiscard]] double duration() const { return rise + hold + fall; }
  [[nodiscard]] double advance() const {  // W of (1)
    const double rest = hold + fall;
    const double gained = (begin + peak) / 2 * rise;
    return rise * rise * (2 * begin + peak) / 6 + gained * rest +
           peak * (hold * (hold / 2 + fall) + fall * fall / 3);
  }
};

/// Law with a limit of acceleration (u/s^2) and of jerk (u/s^3; infinite: the acceleration steps).
struct JerkLaw {
  double acceleration;
  double jerk = std::numeric_limits<double>::infinity();

  [[nodiscard]] RampShape ramp(double dv) const {
    const bool reaches = dv * jerk >= acceleration * acceleration;
    const double edge = reaches ? acceleration / jerk : std::sqrt(dv / jerk);
    if (!reaches) return {0, jerk * edge, edge, 0, edge};
    return {0, acceleration, edge, dv / acceleration - edge, edge};
  }
};

/// Law whose acceleration rises during half of `share` of the ramp's duration T, and falls during
/// the other half of `share`. It begins at `begin` times its peak a:
///
///   (3)  dv = a T (1 - share/2 + share begin/4)
struct ShareLaw {
  double acceleration;  ///< peak, u/s^2
  double share = 0;     ///< 0 to 1
  double begin = 0;     ///< 0 to 1

  [[nodiscard]] RampShape ramp(double dv) const {
    const double T = dv / (acceleration * (1 - share / 2 + share * begin / 4));
    const double edge = share * T / 2;
    return {begin * acceleration, acceleration, edge, (1 - share) * T, edge};
  }
};

/// Law of a sin^2 velocity: v = dv sin^2(pi t / 2T). Its acceleration is a half sine wave of mean
/// dv/T and of peak pi/2 dv/T.
struct SineLaw {
  struct Edge {
    double dv = 0;
    double length = 0;
    [[nodiscard]] double duration() const { return length; }
    [[nodiscard]] double advance() const { return dv * length / 2; }
  };
  double mean;  ///< mean acceleration, u/s^2

  [[nodiscard]] Edge ramp(double dv) const { return {dv, dv / mean}; }
};

/// Distance of a ramp from v by dv: D of (1).
template <class Law>
double distance(const Law& law, double v, double dv) {
  if (!(dv > 0)) return 0;
  const auto ramp = law.ramp(dv);
  return v * ramp.duration() + ramp.advance();
}

/// Returns the greatest x in [0, most] with distance(x) <= h; `distance` does not decrease.
template <class Distance>
double greatest(double most, double h, Distance distance) {
  if (distance(most) <= h) return most;
  double low = 0;
  double high = most;
  for (double x = high / 2; x > low && x < high; x = low + (high - low) / 2)
    (distance(x) <= h ? low : high) = x;
  return low;
}

/// A move over a distance h > 0: its two ramps and its cruise.
template <class Law>
struct RampedMove {
  Law up, down;             ///< laws of the first and of the second ramp
  double v0 = 0, v1 = 0;    ///< velocities at the start and at the end, u/s
  double dv0 = 0, dv1 = 0;  ///< changes of velocity from v0 and from v1 to the peak, u/s
  double cruise = 0;        ///< duration of the cruise, s
};

/// Solves (2) for a peak of at most `velocity` >= v0, v1. nullopt if h is too short for the change
/// from v0 to v1. The unknown is the peak minus the faster end, which may be far below the rounding
/// of the peak.
template <class Law>
std::optional<RampedMove<Law>> ramped(const Law& up, double v0, const Law& down, double v1,
                                      double velocity, double h) {
  const double low = std::max(v0, v1);
  const auto both = [&](double rise) {
    return distance(up, v0, low - v0 + rise) + distance(down, v1, low - v1 + rise);
  };
  const double slack =
      4 * std::numeric_limits<double>::epsilon() * low;  // rounding of the end velocities
  if (both(-slack) > h * (1 + rounded_value)) return std::nullopt;
  const double rise = greatest(velocity - low, h, both);
  const double left = h - both(rise);
  // A rest of h within rounding is no cruise.
  const double cruise = left > rounded_value * h ? left / (low + rise) : 0;
  return RampedMove<Law>{up, down, v0, v1, low - v0 + rise, low - v1 + rise, cruise};
}

/// Returns the move as a profile of order 2 (no jerk limit, or share 0) or 3, from position `from`
/// to `to`.
template <class Law>
Profile profile(const RampedMove<Law>& move, double from, double to);

/// Returns the move as a curve from time 0, from position `from` to `to`.
Trajectory curve(const RampedMove<SineLaw>& move, double from, double to);

}  // namespace jounce::profiles_detail
