// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "jounce/design/detail/path_cost.hpp"
#include "jounce/path/overlap.hpp"
#include "jounce/profiles/limits/limits.hpp"
#include "jounce/spec/spec.hpp"

namespace jounce {

/// Place of a G-code word that moves no axis, such as M3.
struct EventPlace {
  GcodeEvent event = {};
  double where = 0;  ///< length along the path at this place
  double time = 0;   ///< s, time at which the axes have reached the place and the preceding dwells
                     ///< have ended
  Point position{};  ///< position of the axes
};

/// Results of a check for a planned path as a whole. Durations are in the spec's unit of time,
/// lengths in its unit of length.
struct PathSummary {
  double duration = 0;                ///< without the override
  std::optional<double> played = {};  ///< duration with [[override]], if the spec has it
  double stop_duration = 0;           ///< duration with a stop at each corner
  double lower_bound = 0;  ///< proven lower bound of the duration, without a limit of jerk
  double length = 0;       ///< length of the path, with its rounded corners
  /// time lost against full speed; `where` of each loss and of each corner is a length along the
  /// path
  PathCost cost = {};
  /// one for each junction of two commands that has a corner or a note (CornerRecord::note)
  std::vector<CornerRecord> corners = {};
  std::vector<EventPlace> events = {};  ///< places of the words of a G-code program
  Report along = {};                    ///< result of path_report()
  /// if the program is planned in the joints of a robot: greatest distance between the planned
  /// motion and the exact kinematics
  std::optional<MapFit> fit = {};
};

/// Checks the motion along the path, with the override of the spec, against [path.limits] and the
/// limits of the commands; see check_along() (jounce/path/along.hpp).
Report path_report(const Spec& spec, const Plan& played);

/// Returns the places of events. Requires events in the order of the program. The place of an event
/// is the start of the first command in or after its line. The time of the event includes the
/// dwells before this line.
std::vector<EventPlace> places_of(const PathSpec& path, const Plan& plan,
                                  std::span<const GcodeEvent> events);

/// Returns one place for each line of the program that contains a command: the start of the first
/// command of this line.
std::vector<EventPlace> places_of_lines(const PathSpec& path, const Plan& plan);

/// Returns the results for a spec of kind "path". `plan` is the plan that is played, with the
/// override of the spec. `played`, `along` and `events` describe this plan; all other results
/// describe the plan without the override.
PathSummary summary_of(const Spec& spec, const Plan& plan);

/// Returns the results as text: durations, lost time, and the ten places that lose most.
std::string path_text(const Spec& spec, const PathSummary& summary);

/// Returns all results as JSON: {"duration": ..., "corners": [...], ...}.
std::string path_json(const Spec& spec, const PathSummary& summary);

/// Returns one line with the durations and lengths of two plans, and their differences.
std::string path_difference(const Spec& spec, const Plan& before, const Plan& after);

/// Returns one line of text: the proven lower bound of the duration of a plan, and the duration as
/// a multiple of the bound.
std::string path_bound(const Spec& spec, const Plan& plan);
/// Return the result of overlapping lines as text and as JSON: the duration, and the overlap and
/// deviation of each corner.
std::string overlap_text(const Spec& spec, const Overlapped& motion);
std::string overlap_json(const Spec& spec, const Overlapped& motion);

}  // namespace jounce
