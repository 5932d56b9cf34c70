// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "jounce/design/path_cost.hpp"
#include "jounce/path/overlap.hpp"
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
  double duration = 0;                ///< without the override
  std::optional<double> played = {};  ///< duration under [[override]], if the spec has it
  double stop_duration = 0;           ///< duration with a stop at each corner
  double lower_bound = 0;             ///< proven; the jerk is not limited there
  double length = 0;                  ///< length of the path, with its corners
  PathCost cost;
  std::vector<CornerRecord> corners;
  std::vector<EventPlace> events;
  Report along;                    ///< path_report()
  std::optional<MapFit> fit = {};  ///< joints: how far their motion is from the kinematics
};

/// The motion along the path, under the override of the spec, within [path.limits] and the limits of the commands:
/// check_along().
Report path_report(const Spec& spec, const Plan& played);

/// The places of events, which are in the order of the program: where the first command in or behind the line of an
/// event begins, and when, after the dwells before that line.
std::vector<EventPlace> places_of(const PathSpec& path, const Plan& plan,
                                  std::span<const GcodeEvent> events);

/// The same of each line of the program with a command: where the axes begin to follow it.
std::vector<EventPlace> places_of_lines(const PathSpec& path, const Plan& plan);

/// `spec` is of kind "path", and `plan` was made of it. Under an override the events are those of `plan`; all other
/// numbers are those of the plan without it.
PathSummary summary_of(const Spec& spec, const Plan& plan);

/// The summary for people: times, costs, and the ten places that cost most.
std::string path_text(const Spec& spec, const PathSummary& summary);

/// The same in full: {"duration": ..., "corners": [...], ...}.
std::string path_json(const Spec& spec, const PathSummary& summary);

/// Durations and lengths of two plans, and their differences: a line for people.
std::string path_difference(const Spec& spec, const Plan& before, const Plan& after);

/// The proven lower bound of the duration of a plan, and the duration as a multiple of it: a line for
/// people.
std::string path_bound(const Spec& spec, const Plan& plan);

/// Duration of lines that overlap, and overlap and deviation at each corner: for people, and as JSON.
std::string overlap_text(const Spec& spec, const Overlapped& motion);
std::string overlap_json(const Spec& spec, const Overlapped& motion);

}  // namespace jounce
