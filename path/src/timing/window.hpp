// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "jounce/path/law.hpp"

namespace jounce {

/// A stretch of a run for the law of a window: its length and, for a tangential acceleration and jerk, the greatest
/// velocity that keeps all limits.
struct CappedLength {
  double length = 0;
  double velocity = 0;
};

/// A phase of constant acceleration of a law of second order.
struct RawPhase {
  double duration = 0;
  double v0 = 0, v1 = 0;
  [[nodiscard]] double length() const { return duration * (v0 + v1) / 2; }
};

/// The fastest law of second order from rest to rest under the caps, each held `window` s before and behind, with
/// the acceleration, in which no local maximum lasts less than `window` s (docs/path/README.md, "Window").
std::vector<RawPhase> spread_law(std::span<const CappedLength> caps, double acceleration,
                                 double window);

/// Its average over the window: jerk at most acceleration / window. Phases with positions from 0 to `length`, that of
/// the law to rounding.
std::vector<LawPhase> averaged(std::span<const RawPhase> raw, double window, double length);

}  // namespace jounce
