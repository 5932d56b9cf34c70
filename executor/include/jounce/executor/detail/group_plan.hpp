// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "jounce/axis/detail/group_program.hpp"
#include "jounce/axis/detail/path_commands.hpp"
#include "jounce/executor/executor_options.hpp"
#include "jounce/path/program.hpp"
#include "jounce/path/program_numbers.hpp"

/// Paths of a group, planned within the limits of its axes, or of its joints.
namespace jounce {

/// Checks a plan against the limits of the axes of the group (group_program()), and adds what the
/// group needs to play it. Throws InputError like group_program().
GroupProgram checked_program(std::shared_ptr<const Plan> plan, const ExecutorGroup& group);

/// Plans a program, and checks the plan against the limits of the axes of the group. `limits`:
/// limits of the sender for the coordinates of the program and for its path; they are lowered to
/// the limits of the group. Throws InputError like plan() and group_program(), and PlanCanceled.
std::shared_ptr<const GroupProgram> planned_program(const Program& program,
                                                    const GroupLimits& limits,
                                                    const ExecutorGroup& group,
                                                    const std::atomic<bool>* canceled = nullptr);

/// Throws InputError "axes" unless a program for axes with these names fits the coordinates of the
/// group. A group without kinematics permits other names, as require_order() does.
void require_coordinates(std::span<const std::string> names, const ExecutorGroup& group);

/// Throws InputError unless the program fits the coordinates of the group: their names (like the
/// overload above), their units, and their followers (like require_followers()).
void require_coordinates(const LimitedProgram& program, const ExecutorGroup& group);

/// Throws InputError, with the name of the axis, for a path axis of a program that is a follower of
/// the group.
void require_followers(const Program& program, const ExecutorGroup& group);

/// Plans the motion of a group from the positions `from` of its axes to coordinates, in which each
/// axis moves in its own shortest time (DirectMode::fast). Throws InputError if the coordinates are
/// out of reach or outside the range of an axis, or if no axis moves.
std::shared_ptr<const GroupProgram> fast_program(const Point& from, const Point& to,
                                                 const ExecutorGroup& group);

/// Returns the space that the commands of a group can reach: the limits of the coordinates and of
/// the joints.
GroupSpace space_of(const ExecutorGroup& group);

/// Returns the positions of the axes of a group at these coordinates: the inverse kinematics.
/// Throws InputError "to" if they are out of reach, or singular.
Point axes_at(const Point& coordinates, const ExecutorGroup& group);

/// Returns the coordinates of a group from the positions of its axes: the forward kinematics.
/// Returns nullopt if the joints do not fit together.
std::optional<Point> tool_of(const Point& axes, const ExecutorGroup& group);
/// Like tool_of(), but throws InputError "start" if the joints do not fit together.
Point coordinates_of(const Point& axes, const ExecutorGroup& group);

}  // namespace jounce
