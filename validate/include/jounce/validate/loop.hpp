// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <complex>
#include <optional>
#include <vector>

#include "jounce/validate/drive.hpp"

namespace jounce {

/// Distance of the loop from instability, and the frequency of its oscillation there.
struct LoopMargin {
  double value = 0;      ///< a gain: dB; a phase: deg
  double frequency = 0;  ///< Hz
};

/// A pole of the closed loop: exp(pole t) is a free motion of the drive.
struct LoopPole {
  double growth = 0;     ///< 1/s, its real part: >= 0 means that it does not die away
  double frequency = 0;  ///< Hz, >= 0; 0: it does not swing
  double damping = 0;    ///< ratio to the critical one
};

/// Stability of the loop of a drive, with its margins.
struct LoopStability {
  bool stable = true;
  std::vector<LoopPole> poles;  ///< poles of each conjugate pair one, the one that grows most first
  /// Factor by which the gain may rise (positive) or fall (negative) until the loop becomes
  /// unstable, whichever is less. For an unstable loop: the distance to the nearest factor at which
  /// a pole crosses, always negative. Nothing if no factor makes a pole cross.
  std::optional<LoopMargin> gain;
  /// Phase margin: additional lag (or lead) permitted at |L| = 1; negative for an unstable loop.
  std::optional<LoopMargin> phase;
  /// For an unstable loop: the velocity gain (N m s/rad) below which it is stable, if there is one.
  std::optional<double> velocity_gain;
};

/// Poles and margins of the loop of both controllers, opened where the torque enters the motor. So
/// L = velocity gain times everything else, so the gain margin is that of `velocity_gain`.
///
///     const LoopStability loop = loop_stability(drive);
///     if (!loop.stable) ...  loop.poles.front().frequency      // Hz at which it starts to swing
///
/// The poles are eigenvalues: of the drive's equations, or, with a sampled controller, of their map
/// over one cycle. Dry friction, backlash, gear losses, an arm, the torque limit and encoder counts
/// are ignored. Stable means that no pole grows by more than the rounding of the eigenvalues.
///
/// Margins: crossings of |L| = 1 and of the negative real axis are bracketed on a grid of 200 frequencies
/// a decade, finer about each pole, and bisected to rounding. Two crossings between neighbors of that grid
/// are missed.
///
/// Source: K. J. Astrom, R. M. Murray, *Feedback Systems*, 2nd ed. 2021, 10.3 (margins). Throws
/// InputError like require_valid(drive), and for a delay of more than 100 cycles.
LoopStability loop_stability(const Drive& drive);

/// The poles alone, as LoopStability has them: a fraction of the cost.
std::vector<LoopPole> loop_poles(const Drive& drive);

/// True if a pole grows, by more than rounding; `poles` as loop_poles() has them.
bool is_stable(const std::vector<LoopPole>& poles);

/// A point of the loop's frequency response.
struct LoopPoint {
  double frequency = 0;  ///< Hz
  std::complex<double> value;
};

/// L over the frequencies at which margins are looked for, ascending.
std::vector<LoopPoint> loop_response(const Drive& drive);

/// The finding "drive/stability": broken if the loop is unstable, with its frequency in Hz as
/// `where`. Nothing if the loop is stable, or if loop_stability() throws.
std::optional<Finding> unstable_loop(const Drive& drive);

}  // namespace jounce
