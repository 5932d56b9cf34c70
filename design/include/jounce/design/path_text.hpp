// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "jounce/design/path_cost.hpp"
#include "jounce/profiles/limits/limits.hpp"
#include "jounce/spec/spec.hpp"

namespace jounce {

/// Place of a word of a G-code program that does not move the axes.
struct EventPlace {
  GcodeEvent event;
  double where = 0;  ///< q
  double time = 0;   ///< when the axes get there and, after a dwell, when it ends
  Point position{};
};

/// Statements of a check about a planned path as a whole.
struct PathSummary {
  double duration = 0;
  double stop_duration = 0;  ///< duration with a stop at each corner
  double lower_bound = 0;    ///< proven; the jerk is not limited there
  double length = 0;         ///< length of the path, with its corners
  PathCost cost;
  std::vector<CornerRecord> corners;
  std::vector<EventPlace> events;
  /// Velocity, acceleration and jerk along the path within [path.limits]: exact extrema of the timing law. Where
  /// acceleration and deceleration differ, the greater one counts.
  Report along;
  std::optional<MapFit> fit = {};  ///< joints: how far their motion is from the kinematics
};

/// `spec` is of kind "path", and `plan` was made of it.
PathSummary summary_of(const Spec& spec, const Plan& plan);

/// The summary for people: times, costs, and the ten places that cost most.
std::string path_text(const Spec& spec, const PathSummary& summary);

/// The same in full: {"duration": ..., "corners": [...], ...}.
std::string path_json(const Spec& spec, const PathSummary& summary);

}  // namespace jounce
