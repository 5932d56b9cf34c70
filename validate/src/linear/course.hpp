// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <span>

#include "jounce/validate/signal_view.hpp"

#include "validate/src/witness/piece.hpp"

namespace jounce::validate_detail {

// Functions that every run along a reference shares.

/// Greatest step of a solver, as a share of an interval. No law has zeros at multiples of it.
inline constexpr double longest_step = 0.3;

/// A reference after its end, as a signal.
struct Standstill {
  double position;
  std::array<double, 2> interval;

  [[nodiscard]] double start() const { return interval[0]; }
  [[nodiscard]] double end() const { return interval[1]; }
  [[nodiscard]] std::span<const double> breaks() const { return interval; }
  [[nodiscard]] Jet jet(double, Side) const { return {position, 0, 0, 0}; }
};

/// Returns the scale; 1 if it is not positive and finite.
double usable(double scale);

/// Returns the rounding of times on an axis from `from` to `to`.
double shortest_time(double from, double to);

/// True if position, velocity or acceleration steps from one piece to the next by more than
/// rounding (acceleration: by more than error control handles). The solver then restarts.
bool steps(const Jet& before, const Jet& after, const Scales& size);

}  // namespace jounce::validate_detail
