// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "jounce/profiles/curve/curve.hpp"

namespace jounce {

/// A vibration that a motion may excite: the position x of a load on a spring behind the axis,
///
///     (1)  x'' + 2 D w x' + w^2 x = w^2 f(t),   w = 2 pi frequency
///
/// f(t) is the position of the axis. `frequency` is the undamped frequency. A measured decay
/// oscillates with frequency * sqrt(1 - D^2), which differs by 0.05 % at D = 0.03.
struct Mode {
  double frequency = 0;  ///< Hz, > 0
  double damping = 0;    ///< D, a ratio: 0 <= D < 1
};

/// One impulse of an input shaper: the time and amplitude of a copy of the command. The amplitudes
/// of a shaper have the sum 1.
struct Impulse {
  double time = 0;       ///< s, >= 0
  double amplitude = 1;  ///< share of the command
};

/// Returns the residual vibration of a mode after a shaper. It is the vibration after the last
/// impulse, divided by the vibration after a single impulse of amplitude 1 at the same instant. 0
/// means no vibration; 1 means as much as without a shaper. Closed form (Singer & Seering 1990, J.
/// Dyn. Sys. Meas. Control 112, eq. 3). Throws InputError for a mode out of range, and like
/// require_valid().
double residual_vibration(std::span<const Impulse> impulses, const Mode& mode);

/// The greatest residual vibration over a band of frequencies, and its frequency.
struct WorstResidual {
  double residual = 0;   ///< the result of residual_vibration()
  double frequency = 0;  ///< Hz
};

/// Returns the greatest residual vibration for frequencies from low to high (Hz) at the given
/// damping. No frequency of the band exceeds the result by more than 1e-6, because the slope of the
/// residual is bounded. Throws InputError unless 0 < low <= high, and like require_valid().
WorstResidual worst_residual(std::span<const Impulse> impulses, double damping, double low,
                             double high);

/// Returns the residual vibration after a motion, in the curve's unit u. The result is the
/// amplitude of the free vibration of a load that obeys (1), at the instant at which the motion
/// ends. Before the motion, the load is at rest. Before and after its interval, the motion is at
/// rest; steps of the position are permitted.
///
/// Exact: a closed form for polynomials and sines. The error is rounding, about 1e-15 of the travel
/// for each segment. Throws InputError for a mode out of range.
double residual_vibration(const Trajectory& motion, const Mode& mode);

/// Throws InputError unless frequency > 0 and 0 <= damping < 1.
void require_valid(const Mode& mode);

/// Throws InputError unless there is an impulse, times and amplitudes are finite, and the times are
/// not negative and do not descend.
void require_valid(std::span<const Impulse> impulses);

}  // namespace jounce
