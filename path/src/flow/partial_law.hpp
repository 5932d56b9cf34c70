// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <vector>

#include "jounce/path/plan.hpp"

#include "path/src/timing/stations.hpp"
#include "path/src/timing/stretch.hpp"

// Laws that leave their plan: by a hold, an override, a retreat.
namespace jounce {

/// A stretch of a corner: passed at one velocity.
inline bool is_corner(const LawStretch& s) {
  return !s.single_phase && s.pieces > 0 && !std::isfinite(s.deceleration);
}

/// The lowest velocity at the end of `length` that begins at v: 0, or that of one ramp over all of it.
double lowest_end(const Box& box, double length, double v);

/// Collects the stretches of a law in the order of time.
struct PartialLaw {
  std::vector<LawStretch> law = {};

  [[nodiscard]] double time() const {
    return law.empty() ? 0 : law.back().time + law.back().duration;
  }
  void add(LawStretch s) {
    s.time = time();
    law.push_back(s);
  }
  /// A phase of constant jerk from a place within a stretch.
  void phase(const LawStretch& whole, double at, double duration, const Motion& m);
  /// The first t seconds of a stretch.
  void until(const LawStretch& whole, double t);
  /// A rest at q; none if the duration is 0.
  void rest(const Path& path, double q, double duration);
};

/// Throws InputError for a place in a corner: no law rests there.
void require_no_corner(const Plan& plan, const char* key, double q);

/// A stretch of a plan as a unit: its box up to its peak, its start velocity as the greatest there.
Unit unit_of(const LawStretch& s);

/// The units of a plan from rest to rest, with the dwell before each. Every law within their boxes, at no station faster
/// than the plan, keeps all limits.
struct PlannedUnits {
  std::vector<Unit> units;
  std::vector<double> starts;  ///< q of each, and the end
  double last_dwell = 0;       ///< s, behind the last one
};
PlannedUnits units_of(const Plan& plan);

/// The plan with all of its stretches by the law of stations: itself, or planned again where it runs by the law of a
/// window or feeds are `factor` times those of the program.
Plan by_stations(const Plan& plan, double factor);

}  // namespace jounce
