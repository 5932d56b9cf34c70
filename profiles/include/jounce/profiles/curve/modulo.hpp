// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "jounce/profiles/moves/move.hpp"

namespace jounce {

/// A position on an axis that comes round again: turns * period + position.
struct Turned {
  double position = 0;  ///< u, in [0, period)
  double turns = 0;     ///< whole turns; exact up to 2^53
};

/// Reduces a position into one turn (Agito ModRev; HIMC SetRollover and GetRolloverTurns, HMPL
/// manual 5.3.39).
///
///     Turned spot = rolled(-10, 360);               // 350 in turn -1
///     double far = rolled(1e15 + 90, 360).position; // exact: no drift, however many turns
///
/// The remainder is exact (no rounding in a division). Below zero, position = remainder + period is
/// rounded once; a result that would round to a whole period is position 0 of the next turn. Throws
/// InputError unless the period is positive and x finite, and for more turns than a double can
/// hold.
Turned rolled(double x, double period);

/// turns * period + position, rounded once.
double unrolled(const Turned& spot, double period);

/// Direction to a target on a modulo axis; PMC600 MC_DIRECTION and its codes (section 4.1).
enum class Direction {
  negative = -1,
  shortest = 0,
  positive = 1,
  current = 2,  ///< the way the axis moves now; at rest the shortest
  fastest = 3,  ///< the way that takes less time, from the state it is in
};

/// Target of a modulo axis.
struct ModuloTarget {
  MoveStatus status = MoveStatus::ok;  ///< why there is none (current, fastest and one-way only)
  double distance = 0;                 ///< u, signed, from the present position
  double position = 0;                 ///< u, not reduced: present position + distance
};

/// Resolves the target `to` (in turn, any position congruent to it will do) for an axis at `from`.
///
///     const Bounds axis = within(720, 7200);
///     const ModuloTarget target =
///         modulo_target({.position = 350}, 10, Direction::shortest, 360, axis);
///     const Move move = move_to({.position = 350}, {.position = target.position}, axis);  // +20
///
/// **Shortest** counts from the present position, even in motion: at most half a turn; exactly half
/// a turn goes in the positive direction. **Positive** and **negative** never reverse an axis that
/// moves in the requested direction: a target nearer than the stopping distance is reached one turn
/// later. An axis that moves in the other direction stops first, and counts from there. At the
/// target already (within 1e-12 of a turn): no motion. **Fastest** compares the minimum durations
/// (`durations`) of the nearest targets on both sides of the present position and of the stopping
/// point; a tie goes to the shorter way, then to the positive one.
///
/// Exact for any number of turns: the distance is formed from the remainders. Keep the position of
/// an endless axis reduced, and plan by distance; a sum of 1e12 turns loses digits.
/// Throws InputError for a period that is not positive or values that are not finite.
ModuloTarget modulo_target(const MotionState& from, double to, Direction direction, double period,
                           const Bounds& bounds);

/// Agito's conditions for ModRev (PCSuite manual 5.3) with a jerk exponent: throws InputError with
/// the key `ModRev` or `Jerk` unless M is a whole number in [1, 2e9], Jerk one in [0, 9], M *
/// 2^Jerk < 2^31 - 1, and the time to travel M at the maximum speed (counts/s) exceeds the jerk
/// time 2^Jerk / 16384 s.
void require_agito_modulo(double modulo, int jerk, double speed_max);

}  // namespace jounce
