// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <optional>

namespace jounce {

/// Questions that a planner asks again and again, answered by formulas (at most one quartic, a few
/// steps from its root): no profile is built.
///
///     const Ramp ramp{.acceleration = 20, .jerk = 100};               // u/s^2, u/s^3
///     const auto stop = stopping({.velocity = 10}, ramp);             // 0.7 s, 3.5 u
///     const auto entry = entry_velocity(3.5, 0, ramp);                // 10 u/s stops in 3.5 u
///     const auto peak = peak_velocity(20, {}, ramp);                  // fastest over 20 u
///     const auto time = minimum_duration(20, {.velocity = 10}, ramp); // s, rest to rest
///     if (!entry) ...                                                 // there is no such motion
///
/// **Vocabulary.** A *ramp* is a change between two velocities that begins and ends without
/// acceleration. A *span* is a distance with a velocity at either end, neither of them backwards.
///
/// **Units**: u, u/s, u/s^2, u/s^3 and s. Distances and velocities run in the direction of travel.
/// **Impossible questions** (no such motion, a value that is not finite, a limit that is not > 0)
/// are answered with nothing; so is a limit or a distance (not 0) less than 1e-30, and any input that is
/// finite and greater than 1e30. Nothing throws, nothing allocates. A jerk that is infinite gives
/// the answers of second order (trapezoids).
///
/// **Accuracy**: within 1e-14 of the exact answer to the given numbers, relative, wherever the
/// answer is well-conditioned; results do not depend on the unit. Derivation: query.cpp.
struct Ramp {
  static constexpr double none = std::numeric_limits<double>::infinity();

  double acceleration = 0;  ///< u/s^2, > 0; the magnitude permitted in both directions
  double jerk = none;       ///< u/s^3, > 0
};

/// Duration and distance.
struct Extent {
  double duration = 0;  ///< s
  double distance = 0;  ///< u, signed
};

/// The ramp from one velocity to another, of either sign: T = |dv|/a + a/j if a is reached, else 2
/// sqrt(|dv|/j); distance (v0 + v1)/2 T.
std::optional<Extent> ramp_between(double v0, double v1, const Ramp& ramp) noexcept;

/// State of an axis for a stop: u/s, u/s^2, of either sign.
struct Moving {
  double velocity = 0;
  double acceleration = 0;
};

/// Time and distance of the fastest stop, to v = a = 0. An acceleration beyond the ramp's limit is
/// brought back as fast as the jerk permits; with infinite jerk it counts as 0.
std::optional<Extent> stopping(const Moving& now, const Ramp& ramp) noexcept;

/// The highest velocity >= exit_velocity >= 0 from which one ramp leads to exit_velocity within
/// distance >= 0. Read backwards in time: the highest velocity that can be reached from there.
std::optional<double> entry_velocity(double distance, double exit_velocity,
                                     const Ramp& ramp) noexcept;

/// The ends of a span and its velocity limit: u/s, all >= 0; the ends not above the limit.
struct SpanEnds {
  double entry = 0;
  double exit = 0;
  double velocity = std::numeric_limits<double>::infinity();  ///< limit, > 0
};

/// The highest velocity on the fastest way over distance > 0 between the given ends (without
/// acceleration there). Nothing if the distance is too short for the ramp between them.
std::optional<double> peak_velocity(double distance, const SpanEnds& ends,
                                    const Ramp& ramp) noexcept;

/// Duration of the fastest such motion: the ramps to the peak velocity and back, and the cruise
/// between them. Equal to move_to(...) between the same states.
std::optional<double> minimum_duration(double distance, const SpanEnds& ends,
                                       const Ramp& ramp) noexcept;

}  // namespace jounce
