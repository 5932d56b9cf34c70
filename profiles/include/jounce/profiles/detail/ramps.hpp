// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "jounce/profiles/detail/tolerances.hpp"
#include "jounce/profiles/moves/profile.hpp"

// Moves made of two velocity ramps and a cruise, v0 -> peak -> v1, with no acceleration at the joints.
// A law gives the shape of a ramp over dv >= 0; the end ramp is one run backwards in time. A ramp
// from v (or, run backwards, to v) covers
//
//   (1)  D(v, dv) = v T(dv) + W(dv),   W = integral of (T - t) a(t) dt
//
// and the peak velocity p of a move over h that does not cruise solves, D growing with dv,
//
//   (2)  D(v0, p - v0) + D(v1, p - v1) = h,   each under its own law.

namespace jounce::profiles_detail {

/// A change of velocity by acceleration in three stretches: linear from `begin` to `peak` during
/// `rise`, constant during `hold`, linear to zero during `fall`.
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

/// Acceleration that steps (jerk infinite) or ramps at a jerk.
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

/// Acceleration that takes `share` of every ramp's time to rise and to fall, half of it each, and
/// begins at `begin` times its peak:
///   (3)  dv = a T (1 - share/2 + share begin/4)
struct ShareLaw {
  double acceleration;
  double share = 0;
  double begin = 0;

  [[nodiscard]] RampShape ramp(double dv) const {
    const double T = dv / (acceleration * (1 - share / 2 + share * begin / 4));
    const double edge = share * T / 2;
    return {begin * acceleration, acceleration, edge, (1 - share) * T, edge};
  }
};

/// sin^2 of velocity: v = dv sin^2(pi t / 2T), whose acceleration is a half wave of mean dv/T and
/// peak pi/2 times that.
struct SineLaw {
  struct Edge {
    double dv = 0;
    double length = 0;
    [[nodiscard]] double duration() const { return length; }
    [[nodiscard]] double advance() const { return dv * length / 2; }
  };
  double mean;

  [[nodiscard]] Edge ramp(double dv) const { return {dv, dv / mean}; }
};

template <class Law>
double distance(const Law& law, double v, double dv) {  // (1)
  if (!(dv > 0)) return 0;
  const auto ramp = law.ramp(dv);
  return v * ramp.duration() + ramp.advance();
}

/// The greatest x from 0 to `most` for which `distance`, which grows, is not above h.
template <class Distance>
double greatest(double most, double h, Distance distance) {
  if (distance(most) <= h) return most;
  double low = 0;
  double high = most;
  for (double x = high / 2; x > low && x < high; x = low + (high - low) / 2)
    (distance(x) <= h ? low : high) = x;
  return low;
}

/// A move over h > 0: its ramps and its cruise.
template <class Law>
struct RampedMove {
  Law up, down;
  double v0 = 0, v1 = 0;    ///< at the ends
  double dv0 = 0, dv1 = 0;  ///< from there to the peak
  double cruise = 0;        ///< s
};

/// Solves (2) up to `velocity` >= v0, v1. nullopt if h is too short to get from v0 to v1. The
/// unknown is the rise above the faster end, which may be far below the rounding of the peak.
template <class Law>
std::optional<RampedMove<Law>> ramped(const Law& up, double v0, const Law& down, double v1,
                                      double velocity, double h) {
  const double low = std::max(v0, v1);
  const auto both = [&](double rise) {
    return distance(up, v0, low - v0 + rise) + distance(down, v1, low - v1 + rise);
  };
  const double slack =
      4 * std::numeric_limits<double>::epsilon() * low;  // low of the end velocities
  if (both(-slack) > h * (1 + rounded_value)) return std::nullopt;
  const double rise = greatest(velocity - low, h, both);
  const double left = h - both(rise);
  // A rest of h within rounding is no cruise.
  const double cruise = left > rounded_value * h ? left / (low + rise) : 0;
  return RampedMove<Law>{up, down, v0, v1, low - v0 + rise, low - v1 + rise, cruise};
}

/// The same as a profile of order 2 (no jerk, or no share) or 3, from `from` to `to`.
template <class Law>
Profile profile(const RampedMove<Law>& move, double from, double to);

/// The same as a curve from 0.
Trajectory curve(const RampedMove<SineLaw>& move, double from, double to);

}  // namespace jounce::profiles_detail
