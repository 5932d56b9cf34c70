// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "jounce/axis/axis_config.hpp"
#include "jounce/axis/movement.hpp"
#include "jounce/path/path_length.hpp"
#include "jounce/path/plan.hpp"

namespace jounce {

/// An axis of a group: its configuration, with the defaults filled in, and the greatest magnitudes
/// of its motion on the path. u is the unit of the axis.
struct GroupAxis {
  AxisConfig config = {};
  Peaks peaks = {};
};

/// The greatest magnitudes of a program from a rest to its end.
struct ProgramPart {
  double start = 0;              ///< length along the path at which the part begins
  Peaks along = {};              ///< along the path; a short ramp does not reach its acceleration
  std::vector<Peaks> axes = {};  ///< each axis of the group
};

/// An M word that the path of a group passes.
struct PathMWord {
  double time = 0;          ///< s of path time
  std::int32_t number = 0;  ///< its number
};

/// A planned path that was checked against the limits of the axes of a group.
struct GroupProgram {
  std::shared_ptr<const Plan> plan = {};  ///< over s, in the units of the axes
  std::vector<GroupAxis> axes = {};       ///< in the order of the axes of the plan
  /// Place of the first axis of the group among the axes of the plan; not 0 if they are joints.
  std::size_t first = 0;
  /// First the whole program. Then, for each rest after which a magnitude is lower, the part from
  /// this rest to the end. Empty only for a program that was read from a record.
  std::vector<ProgramPart> parts = {};
  std::vector<PathSwitch> switches = {};  ///< outputs that the path switches, in ascending order of
                                          ///< time
  /// Length along the path of the tool, for a position compare; null: q.
  std::shared_ptr<const PathLength> length = {};
  std::vector<PathMWord> m_words = {};  ///< M words that the path passes, in ascending order of
                                        ///< time
};

/// Returns the last part that begins at this length along the path, or before it.
const ProgramPart& part_at(const GroupProgram& program, double length);

/// Returns the greatest magnitudes of a timing law along its path.
Peaks peaks_of(const TimingLaw& law);

/// Checks a plan against the limits of the axes that will play it: position range, velocity,
/// acceleration and jerk, by exact extrema, and steps of position, velocity and acceleration (a
/// step of the acceleration counts as a jerk in one cycle, as in a table). Time and memory are
/// proportional to the number of pieces.
///
///     const GroupProgram program = group_program(plan, configs, {{"x", "y"}});
///     GroupPath path(1, program);                               // group_path.hpp
///
/// Throws InputError with the key "axes" if the numbers of axes differ, and with the name of the
/// axis and the broken limit ("x.velocity") if a limit is exceeded by more than a billionth.
/// `units`: units of the axes for messages, one for each axis; no entries: unknown. If the plan has
/// joints, the axes of the group are these joints.
GroupProgram group_program(std::shared_ptr<const Plan> plan, std::span<const AxisConfig> axes,
                           std::span<const std::string> names,
                           std::span<const std::string> units = {});

/// Returns limits of a program, each lowered to the limit of the axis that will play it; position
/// limits are omitted. Throws InputError "axes" if the numbers of axes differ.
GroupLimits within(const GroupLimits& limits, std::span<const AxisConfig> axes);

/// Throws InputError "axes" if some axes of a path have the names of axes of the group, but not all
/// axes are at the same places of both lists. If no name is the same, the first axis of the group
/// plays the first axis of the path.
void require_order(std::span<const std::string> path, std::span<const std::string> group);

/// Returns the configuration of the MotionAxis of a group with these axes. The limits in this
/// configuration have no effect; the limits of the axes apply. Throws InputError "axes" for none.
AxisConfig group_config(std::span<const AxisConfig> axes);

}  // namespace jounce
