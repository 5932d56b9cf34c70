// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

namespace jounce {

/// Many independent moves at once on one core, in columns, for planners that compare thousands of
/// candidates.
///
///     const std::vector<double> way = ..., limit = ...;       // a million ways
///     std::vector<double> seconds(way.size());
///     minimum_durations({.distance = way, .velocity = v, .acceleration = a, .jerk = j}, seconds);
///
/// Every move is of third order, without acceleration at its ends. A column holds one value for
/// each move, or one value for all; entry and exit may be empty: at rest. Units as in query.hpp,
/// which answers the same questions one by one.
struct MoveColumns {
  std::span<const double> distance;      ///< u, of either sign
  std::span<const double> entry = {};    ///< u/s, of either sign; empty: 0
  std::span<const double> exit = {};     ///< u/s
  std::span<const double> velocity;      ///< u/s, limit > 0, may be infinite
  std::span<const double> acceleration;  ///< u/s^2, limit > 0, finite
  std::span<const double> jerk;          ///< u/s^3, limit > 0; infinite: acceleration may step
};

/// The least duration of every move, s; NaN if there is none (a limit not > 0, an end above the
/// velocity limit, a value that is not finite or out of the range of magnitudes in query.hpp).
/// `peak`, if not empty, receives the signed velocity of the cruise or of the peak. Spans of equal
/// size (asserted).
///
/// Uses the widest vectors that the processor has (AVX-512, AVX2, or the baseline). Within 1e-12 of
/// the scalar answer, relative. Does not allocate, does not throw.
void minimum_durations(const MoveColumns& moves, std::span<double> durations,
                       std::span<double> peak = {}) noexcept;

}  // namespace jounce
