// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <optional>

namespace jounce {

/// Answers to frequent questions of a planner, by formulas. No function builds a profile. Each
/// needs at most one quartic equation and a few iterations.
///
///     const Ramp ramp{.acceleration = 20, .jerk = 100};               // u/s^2, u/s^3
///     const auto stop = stopping({.velocity = 10}, ramp);             // 0.7 s, 3.5 u
///     const auto entry = entry_velocity(3.5, 0, ramp);                // 10 u/s stops in 3.5 u
///     const auto peak = peak_velocity(20, {}, ramp);                  // fastest over 20 u
///     const auto time = minimum_duration(20, {.velocity = 10}, ramp); // s, rest to rest
///     if (!entry) ...                                                 // no such motion exists
///
/// **Vocabulary.** A *ramp* is a change of velocity that begins and ends at zero acceleration. A
/// *span* is a distance with given velocities at its two ends.
///
/// **Units**: u, u/s, u/s^2, u/s^3 and s, where u is the axis' unit. Distances and velocities are
/// positive in the direction of travel.
///
/// **No answer.** A function returns std::nullopt in these cases: no such motion exists; a value is
/// not finite; a limit is not positive; a limit or a nonzero distance is below 1e-30; or a finite
/// input is above 1e30. The functions do not throw or allocate. If the jerk is infinite, the
/// answers apply to trapezoids.
///
/// **Accuracy**: the relative error is at most 1e-14 if the question is well-conditioned. Results
/// do not depend on the unit. The derivation is in query.cpp.

/// Limits of a ramp.
struct Ramp {
  static constexpr double none = std::numeric_limits<double>::infinity();  ///< no limit of the jerk

  double acceleration = 0;  ///< u/s^2, > 0; limit of the magnitude in both directions
  double jerk = none;       ///< u/s^3, > 0; default: no limit
};

/// Duration and distance of a motion.
struct Extent {
  double duration = 0;  ///< s
  double distance = 0;  ///< u, signed
};

/// Returns the duration T and the distance of the ramp from velocity v0 to v1 (u/s, any sign). With
/// dv = v1 - v0 and the limits a and j of the ramp, T = |dv|/a + a/j if the ramp reaches the
/// acceleration a, otherwise T = 2 sqrt(|dv|/j). The distance is (v0 + v1)/2 T.
std::optional<Extent> ramp_between(double v0, double v1, const Ramp& ramp) noexcept;

/// Velocity (u/s) and acceleration (u/s^2) of an axis at the beginning of a stop; any sign.
struct Moving {
  double velocity = 0;
  double acceleration = 0;
};

/// Returns the duration and the distance of the fastest stop, which ends at zero velocity and
/// acceleration. If the present acceleration exceeds the ramp's limit, the stop first reduces it as
/// fast as the jerk permits. If the jerk is infinite, the present acceleration counts as 0.
std::optional<Extent> stopping(const Moving& now, const Ramp& ramp) noexcept;

/// Returns the highest velocity from which one ramp leads to exit_velocity within the distance.
/// Arguments and result are >= 0; the result is at least exit_velocity. By symmetry in time, the
/// result is also the highest velocity that a ramp can reach from exit_velocity over this distance.
std::optional<double> entry_velocity(double distance, double exit_velocity,
                                     const Ramp& ramp) noexcept;

/// Velocities at both ends of a span, and the velocity limit between them: u/s, >= 0. The
/// velocities at the ends must not exceed the limit.
struct SpanEnds {
  double entry = 0;                                           ///< velocity at the start
  double exit = 0;                                            ///< velocity at the end
  double velocity = std::numeric_limits<double>::infinity();  ///< limit, > 0; default: none
};

/// Returns the peak velocity of the fastest motion over the given distance > 0, between the
/// velocities of `ends`. The acceleration is zero at both ends. Returns std::nullopt if the
/// distance is too short for the ramp from entry to exit.
std::optional<double> peak_velocity(double distance, const SpanEnds& ends,
                                    const Ramp& ramp) noexcept;

/// Returns the duration of the fastest motion over the given distance > 0, between the velocities
/// of `ends`. The motion consists of a ramp to the peak velocity, a cruise, and a ramp to the exit
/// velocity. The duration equals the duration of move_to() (moves/move.hpp) between the same
/// states.
std::optional<double> minimum_duration(double distance, const SpanEnds& ends,
                                       const Ramp& ramp) noexcept;

}  // namespace jounce
