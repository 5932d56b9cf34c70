// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "jounce/profiles/curve/curve.hpp"

namespace jounce {

/// A second-order notch in front of the axis (HIMC's vibration suppression filter, VSF: HMPL manual
/// 15.1, frequency 0.1 to 200 Hz, damping 0.7 to 1.5, 1.0 suggested):
///
///     (1)  H(s) = (s^2 + 2 D0 w s + w^2) / (s^2 + 2 D w s + w^2),   w = 2 pi frequency
///
/// Its zeros cancel a mode of damping D0; its poles replace it by a well damped one.
struct NotchSpec {
  double frequency = 0;     ///< Hz, > 0
  double damping = 1;       ///< D of the poles, >= 0.05
  double mode_damping = 0;  ///< D0 of the zeros, 0 <= D0 < D
  double settled = 1e-6;    ///< share of the travel at which the tail is cut, > 0 and < 1
};

/// A filtered motion and how far it is from the exact response.
struct Notched {
  Trajectory motion;
  double error = 0;  ///< u; rounding (about 1e-15 of the travel) aside, a bound for all times
};

/// The motion behind the notch.
///
///     const Notched quiet = notched(move, {.frequency = 5.5});
///     const double left = residual_vibration(quiet.motion, {5.5});  // about `settled`
///
/// The response to a piecewise polynomial is polynomials and decaying exponentials, which no
/// Segment holds: it is represented by its Taylor polynomials of degree 10 over steps of an eighth
/// of a radian, with a bounded remainder, and ended by a quintic to rest once the rest of the tail
/// is below `settled` of the travel. `error` bounds both. Continuous in acceleration where f is. f
/// rests before and after (even if it refuses).
///
/// Throws InputError for a value out of range, a motion that wraps or does not move, and one
/// so long that it needs more than a million steps.
Notched notched(const Trajectory& f, const NotchSpec& spec);

}  // namespace jounce
