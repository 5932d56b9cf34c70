// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "jounce/profiles/curve/curve.hpp"

namespace jounce {

/// A vibration that a motion may excite: a load on a spring behind the axis,
///
///     (1)  x'' + 2 D w x' + w^2 x = w^2 f(t),   w = 2 pi frequency
///
/// with the axis at f. The frequency is the undamped one; a decay shows frequency * sqrt(1 - D^2),
/// which differs by 0.05 % at D = 0.03.
struct Mode {
  double frequency = 0;  ///< Hz, > 0
  double damping = 0;    ///< D, a ratio: 0 <= D < 1
};

/// One copy of the command: when, and how much of it. The amplitudes of a shaper add up to 1.
struct Impulse {
  double time = 0;  ///< s, >= 0
  double amplitude = 1;
};

/// Residual vibration of a mode after a sequence of impulses: the amplitude after its last impulse
/// as a share of the residual of a single impulse at that instant. 0: none; 1: like the unshaped
/// motion. Closed form (Singer & Seering 1990, J. Dyn. Sys. Meas. Control 112, eq. 3). Throws
/// InputError for a mode out of range, and like `require_valid`.
double residual_vibration(std::span<const Impulse> impulses, const Mode& mode);

/// Its greatest value over a band of frequencies at fixed damping, and the frequency.
struct WorstResidual {
  double residual = 0;
  double frequency = 0;  ///< Hz
};

/// Not sampled: the residual's slope is bounded, so no frequency of [low, high] exceeds the result
/// by more than 1e-6. Throws InputError unless 0 < low <= high, and like `require_valid`.
WorstResidual worst_residual(std::span<const Impulse> impulses, double damping, double low,
                             double high);

/// Residual amplitude of a load that obeys (1), at rest before the motion, about its place at the motion's
/// end, in the curve's unit u: the envelope of the free vibration at that instant. f is taken to
/// rest before and after; steps of the position are allowed.
///
/// Exact: polynomials and sines against the mode's exponential in closed form; the error is
/// rounding, about 1e-15 of the travel for each segment. Throws InputError for a mode out of range.
double residual_vibration(const Trajectory& motion, const Mode& mode);

/// Throws InputError unless frequency > 0 and 0 <= damping < 1.
void require_valid(const Mode& mode);

/// Throws InputError unless there is an impulse, times and amplitudes are finite, and the times do
/// not descend and are not negative.
void require_valid(std::span<const Impulse> impulses);

}  // namespace jounce
