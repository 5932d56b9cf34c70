// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <vector>

#include "jounce/path/plan.hpp"

#include "path/src/timing/stations.hpp"
#include "path/src/timing/stretch.hpp"

// Laws that deviate from their plan: after a hold, an override or a retreat.
namespace jounce {

/// True for the stretch of a corner, which has constant velocity.
inline bool is_corner(const LawInterval& s) {
  return !s.is_phase() && s.pieces > 0 && !std::isfinite(s.deceleration);
}

/// The lowest velocity that a law can have after `length`, if it begins at v: 0, or the end
/// velocity of one ramp over the whole length.
double lowest_end(const Box& box, double length, double v);

/// Collects the stretches of a law in the order of time.
struct PartialLaw {
  std::vector<LawInterval> law = {};

  [[nodiscard]] double time() const {
    return law.empty() ? 0 : law.back().time + law.back().duration;
  }
  void add(LawInterval s) {
    s.time = time();
    law.push_back(s);
  }
  /// Appends a phase of constant jerk that begins at a place within a stretch.
  void phase(const LawInterval& whole, double at, double duration, const Motion& m);
  /// Appends the first t seconds of a stretch.
  void until(const LawInterval& whole, double t);
  /// Appends a rest at q; nothing if the duration is 0.
  void rest(const Path& path, double q, double duration);
};

/// Gives boxes to a corner that the first or the last of some units of a plan is a part of: a law that begins or ends there
/// changes its velocity within the corner. `units`: successive, from a rest to a rest.
void open_end_corners(std::vector<Unit>& units, const Plan& plan);

/// A stretch of a plan as a unit. Its velocity limit is the peak of the stretch, its greatest entry
/// velocity the start velocity.
Unit unit_of(const LawInterval& s);

/// The units of a plan from rest to rest, with the dwell before each. A law stays within all limits
/// if it stays within the boxes of the units and is at no station faster than the plan.
struct PlannedUnits {
  std::vector<Unit> units;
  std::vector<double> starts;  ///< q of the start of each unit, and of the end
  double last_dwell = 0;       ///< s, dwell after the last unit
};
PlannedUnits units_of(const Plan& plan);

/// The plan with a law of stations throughout. It is planned again if it has the law of a window,
/// or if feeds are `factor` times the feeds of the program; otherwise it is the plan itself.
Plan by_stations(const Plan& plan, double factor);

}  // namespace jounce
