// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

namespace jounce {

/// Columns of many independent moves, whose durations minimum_durations() computes at once on one
/// core. For planners that compare thousands of candidates.
///
///     const std::vector<double> distances(1'000'000, 0.5);       // a million moves
///     std::vector<double> seconds(distances.size());
///     minimum_durations({.distance = distances, .velocity = v, .acceleration = a, .jerk = j},
///                       seconds);
///
/// Every move has limits of velocity, acceleration and jerk, and zero acceleration at its ends. A
/// column holds either one value for each move, or a single value that applies to all moves. For
/// one move, minimum_duration() in query.hpp computes the same. u is the axis' unit.
struct MoveColumns {
  std::span<const double> distance;           ///< u, of either sign
  std::span<const double> entry = {};         ///< velocity at the start, u/s, any sign; empty: 0
  std::span<const double> exit = {};          ///< velocity at the end, u/s, any sign; empty: 0
  std::span<const double> velocity = {};      ///< limit, u/s, > 0; may be infinite
  std::span<const double> acceleration = {};  ///< limit, u/s^2, > 0, finite
  std::span<const double> jerk = {};  ///< limit, u/s^3, > 0; infinite: the acceleration steps
};

/// Writes the least duration of every move (s) to `durations`. The duration is NaN if no move
/// exists: a limit is not positive, the velocity at an end exceeds the limit, or a value is not
/// finite or out of the range of query.hpp (1e-30 to 1e30). If `peak` is not empty, it receives the
/// signed velocity of the cruise, or the peak velocity of a move without cruise (u/s). `durations`,
/// a nonempty `peak` and every column with one value for each move have the same size; otherwise
/// every result is NaN.
///
/// Uses the widest vectors of the processor (AVX-512, AVX2, or the baseline). The relative
/// difference from the result of query.hpp is at most 1e-12. Does not allocate or throw.
void minimum_durations(const MoveColumns& moves, std::span<double> durations,
                       std::span<double> peak = {}) noexcept;

}  // namespace jounce
