#pragma once

#include <array>
#include <span>

#include "jounce/profiles/curve.hpp"

namespace jounce {

/// A move in the compact form that the time generators make: at most seven phases of constant jerk.
///
///     SCurveSpec spec{.to = 50, .velocity = 10, .acceleration = 20, .jerk = 100};
///     Profile move = s_curve(spec);
///     double T = move.duration();          // s
///     Trajectory curve = move.curve();     // exact, for checks, tables and plots
///
/// A phase that does not occur is left out. The move begins and ends at rest, exactly at `from` and
/// `to`: the half after the middle is built backwards from the end.
struct Profile {
  struct Phase {
    double duration = 0;      ///< > 0
    double acceleration = 0;  ///< at the phase's start, signed
    double jerk = 0;          ///< constant over the phase, signed
  };

  double from = 0;
  double to = 0;
  double peak_velocity = 0;  ///< signed
  std::array<Phase, 7> phases{};
  std::size_t count = 0;         ///< phases in use
  std::size_t accelerating = 0;  ///< how many of them come before the middle (cruise or peak)

  void add(double duration, double acceleration, double jerk);
  [[nodiscard]] std::span<const Phase> used() const { return {phases.data(), count}; }
  [[nodiscard]] double duration() const;
  [[nodiscard]] Trajectory curve() const;
};

/// Trapezoidal velocity, rest to rest.
struct TrapezoidSpec {
  double from = 0;          ///< u
  double to = 0;            ///< u; equal to `from` is refused: there is no move
  double velocity = 0;      ///< u/s, > 0; not reached by a short move
  double acceleration = 0;  ///< u/s^2, > 0
  double deceleration = 0;  ///< u/s^2, > 0; 0: as acceleration
};

/// Time-optimal under the limits. Throws InputError for a value out of range.
Profile trapezoid(const TrapezoidSpec& spec);

/// Seven-segment S-curve, rest to rest: acceleration ramps at the given jerk.
struct SCurveSpec {
  double from = 0;               ///< u
  double to = 0;                 ///< u, not equal to `from`
  double velocity = 0;           ///< u/s, > 0
  double acceleration = 0;       ///< u/s^2, > 0
  double deceleration = 0;       ///< u/s^2; 0: as acceleration
  double jerk = 0;               ///< u/s^3, > 0, of the accelerating half
  double deceleration_jerk = 0;  ///< u/s^3, of the decelerating half; 0: as jerk
};

/// Time-optimal under the limits, each half with its own acceleration and jerk. Velocity and
/// acceleration are not reached by short moves. Throws InputError for a value out of range.
Profile s_curve(const SCurveSpec& spec);

}  // namespace jounce
