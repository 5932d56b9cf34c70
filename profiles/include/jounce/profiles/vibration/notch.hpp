// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "jounce/profiles/curve/curve.hpp"

namespace jounce {

/// A notch filter of second order for the setpoints of an axis. HIMC calls it vibration suppression
/// filter (VSF; HMPL manual 15.1: frequency 0.1 to 200 Hz, damping 0.7 to 1.5, suggested 1.0).
///
///     (1)  H(s) = (s^2 + 2 D0 w s + w^2) / (s^2 + 2 D w s + w^2),   w = 2 pi frequency
///
/// The zeros of the filter cancel a vibration mode of damping D0. Its poles add a well-damped mode
/// of the same frequency.
struct NotchSpec {
  double frequency = 0;     ///< Hz, > 0
  double damping = 1;       ///< D of the poles, >= 0.05
  double mode_damping = 0;  ///< D0 of the zeros, >= 0 and < damping
  /// > 0 and < 1. After the end of the given motion, the filtered motion decays. The filter ends
  /// this tail as soon as the rest of the tail is below this share of the travel (the difference
  /// between the greatest and the least position).
  double settled = 1e-6;
};

/// A filtered motion and its error. u is the axis' unit.
struct Notched {
  Trajectory motion;  ///< the filtered motion; begins with the original one and ends at rest
  /// Bound in u of the difference from the exact response at all times, except for rounding (about
  /// 1e-15 of the travel).
  double error = 0;
};

/// Returns the response of the filter to the motion f.
///
///     const Notched quiet = notched(move, {.frequency = 5.5});
///     const double left = residual_vibration(quiet.motion, {5.5});  // about `settled`
///
/// The exact response to a piecewise polynomial contains decaying exponentials, which do not fit a
/// Segment. Taylor polynomials of degree 10 over steps of an eighth of a radian replace them, with
/// a bounded remainder. When the rest of the tail is below `settled` times the travel, a quintic
/// ends the motion at rest. `error` bounds both approximations. The acceleration of the result is
/// continuous where the acceleration of f is continuous. Before and after its interval, f counts as
/// at rest, even if its policy is `refuse`.
///
/// Throws InputError for a value out of range, for a motion that is periodic or does not move, and
/// for a motion so long that it needs more than a million steps.
Notched notched(const Trajectory& f, const NotchSpec& spec);

}  // namespace jounce
