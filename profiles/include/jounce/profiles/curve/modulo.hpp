// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "jounce/profiles/moves/move.hpp"

namespace jounce {

/// A position on a modulo axis. The unreduced position is turns * period + position.
struct Turned {
  double position = 0;  ///< u, in [0, period)
  double turns = 0;     ///< whole number of turns; exact up to 2^53
};

/// Reduces a position to one turn, like ModRev of Agito, and like SetRollover and GetRolloverTurns
/// of HIMC (HMPL manual 5.3.39).
///
///     Turned spot = rolled(-10, 360);               // 350 in turn -1
///     double far = rolled(1e15 + 90, 360).position; // exact for any number of turns
///
/// The remainder is exact for x >= 0. For x < 0, position = remainder + period is rounded once; if
/// the sum rounds to a whole period, the result is position 0 of the next turn. Throws InputError
/// if the period is not positive, if x is not finite, or if the number of turns exceeds the range
/// of a double.
Turned rolled(double x, double period);

/// Returns turns * period + position, rounded once.
double unrolled(const Turned& spot, double period);

/// Direction to a target on a modulo axis. MC_DIRECTION (PMC600 manual, section 4.1) has the same
/// numbers.
enum class Direction {
  negative = -1,
  shortest = 0,
  positive = 1,
  current = 2,  ///< the direction in which the axis moves now; for an axis at rest, like `shortest`
  fastest = 3,  ///< the direction that takes less time from the present state
};

/// Target of a move on a modulo axis.
struct ModuloTarget {
  /// If not ok: the reason why there is no target. `shortest` always has a target.
  MoveStatus status = MoveStatus::ok;
  double distance = 0;  ///< u, signed, from the present position
  double position = 0;  ///< u, not reduced: present position + distance
};

/// Returns the nearest position in the given direction that equals `to` modulo `period`, for an
/// axis in the state `from`. The unit is u.
///
///     const Bounds axis = within(720, 7200);
///     const ModuloTarget target =
///         modulo_target({.position = 350}, 10, Direction::shortest, 360, axis);
///     const MoveResult move = move_to({.position = 350}, {.position = target.position},
///                                     axis);  // +20
///
/// - **shortest** counts from the present position, even in motion: at most half a turn. Exactly
///   half a turn goes in the positive direction.
/// - **positive**, **negative**: an axis that moves in this direction does not reverse. If it
///   cannot stop before the target, it passes the target and stops there one turn later. An axis
///   that moves in the other direction stops first, and the target is counted from the stopping
///   point. An axis that is at the target (within 1e-12 of a turn) does not move.
/// - **current**: the direction of the present velocity; for an axis at rest, shortest.
/// - **fastest** considers the nearest targets on both sides of the present position and of the
///   stopping point, and takes the one with the least duration (see durations() in move.hpp). Of
///   equal durations, the shorter distance wins, then the positive direction.
///
/// The distance is exact for any number of turns, because it is computed from remainders. Keep the
/// position of an endless axis reduced to one turn, and plan by distance: a position of 1e12 turns
/// has too few digits. Throws InputError if the period is not positive, or if `to` or the position
/// is not finite. If move_to() rejects the velocity, the acceleration or the bounds, the result has
/// the status of move_to().
ModuloTarget modulo_target(const MotionState& from, double to, Direction direction, double period,
                           const Bounds& bounds);

/// Checks Agito's conditions for a modulo axis with jerk (PCSuite manual 5.3). `modulo` is ModRev
/// in counts, `jerk` the exponent of the jerk time 2^jerk / 16384 s, `speed_max` in counts/s.
/// Throws InputError with the key `ModRev`, `Jerk` or `Speed` unless
/// - modulo is a whole number in [1, 2e9], and jerk is in [0, 9];
/// - modulo * 2^jerk < 2^31 - 1;
/// - speed_max is positive and finite, and the travel of one modulo at speed_max takes longer than
///   the jerk time.
void require_agito_modulo(double modulo, int jerk, double speed_max);

}  // namespace jounce
