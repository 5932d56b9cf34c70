// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <complex>
#include <optional>
#include <vector>

#include "jounce/validate/drive.hpp"

namespace jounce {

/// A stability margin of a loop, and the frequency at which the loop oscillates when the margin is
/// used up.
struct LoopMargin {
  double value = 0;      ///< gain margin, dB; phase margin, deg
  double frequency = 0;  ///< Hz
};

/// A pole of the closed loop: exp(pole t) is a free motion of the drive.
struct LoopPole {
  double growth = 0;     ///< real part, 1/s; >= 0: the motion does not decay
  double frequency = 0;  ///< Hz, >= 0; 0: no vibration
  double damping = 0;    ///< damping ratio
};

/// Stability of the loop of a drive, with its margins.
struct LoopStability {
  bool stable = true;  ///< true if no pole grows
  std::vector<LoopPole> poles =
      {};  ///< one pole of each conjugate pair; the pole that grows most is
           ///< the first
  /// Gain margin: the factor (in dB) by which the gain can rise (positive) or fall (negative) until
  /// the loop becomes unstable; of the two, the one of smaller magnitude. For an unstable loop it
  /// is always negative: the distance to the nearest factor at which a pole crosses the stability
  /// limit. nullopt: no factor makes a pole cross.
  std::optional<LoopMargin> gain = {};
  /// Phase margin: the additional lag (or lead) at |L| = 1 until the loop becomes unstable;
  /// negative for an unstable loop. nullopt: |L| is not 1 at any frequency that was examined.
  std::optional<LoopMargin> phase = {};
  /// For an unstable loop: the velocity gain, N m s/rad, at which the loop becomes stable; of
  /// several, the one nearest to the gain of the drive. nullopt: the loop is stable, or no such
  /// gain was found.
  std::optional<double> velocity_gain = {};
};

/// Computes the poles and margins of the position loop and the velocity loop together. The loop is
/// opened where the torque enters the motor. The open loop L is the velocity gain times all other
/// factors, so the gain margin applies to `velocity_gain`.
///
///     const LoopStability loop = loop_stability(drive);
///     if (!loop.stable) use(loop.poles.front().frequency);     // Hz at which it starts to swing
///
/// **Poles** are eigenvalues of the equations of the drive, or, for a sampled controller, of their
/// map over one cycle. Dry friction, backlash, gear losses, the weight of an arm, the torque limit
/// and encoder counts are ignored. The loop is stable if no pole grows by more than the rounding of
/// the eigenvalues.
///
/// **Margins** are computed at the crossings of |L| = 1 and of the negative real axis. The
/// crossings are bracketed on a grid of 200 frequencies a decade, finer around each pole, and
/// bisected to rounding. Two crossings between neighboring points of the grid are missed.
///
/// Source: K. J. Astrom, R. M. Murray, *Feedback Systems*, 2nd ed. 2021, 10.3 (margins).
/// Throws InputError like require_valid(drive), and for a delay of more than 100 cycles.
LoopStability loop_stability(const Drive& drive);

/// Returns only the poles, in the order of LoopStability, much faster than loop_stability(). Throws
/// InputError like loop_stability().
std::vector<LoopPole> loop_poles(const Drive& drive);

/// True if no pole grows by more than rounding. Requires the poles of loop_poles().
bool is_stable(const std::vector<LoopPole>& poles);

/// A point of the frequency response of the open loop.
struct LoopPoint {
  double frequency = 0;             ///< Hz
  std::complex<double> value = {};  ///< value of L
};

/// Returns L at the frequencies at which margins are searched, ascending. Throws InputError like
/// loop_stability().
std::vector<LoopPoint> loop_response(const Drive& drive);

/// Returns the broken finding "drive/stability" if the loop is unstable; `where` is the frequency
/// in Hz. Returns nullopt if the loop is stable, or if the delay is more than 100 cycles. Throws
/// InputError like require_valid(drive).
std::optional<Finding> unstable_loop(const Drive& drive);

}  // namespace jounce
