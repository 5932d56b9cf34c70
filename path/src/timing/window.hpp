// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "jounce/path/law.hpp"

namespace jounce {

/// A stretch of a run for the law of a window: its length, and the greatest velocity that stays
/// within all limits for the given tangential acceleration and jerk.
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

/// The fastest law of second order from rest to rest that stays within the caps and the
/// acceleration, and whose local maxima last at least `window` s. Each cap also holds for `window`
/// s before and after its stretch (docs/path/README.md, "Window").
std::vector<RawPhase> spread_law(std::span<const CappedLength> caps, double acceleration,
                                 double window);

/// The average of the law over the window; its jerk is at most acceleration / window. Returns
/// phases with positions from 0 to `length`, which is the length of the law, to rounding.
std::vector<LawPhase> averaged(std::span<const RawPhase> raw, double window, double length);

}  // namespace jounce
