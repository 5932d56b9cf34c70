// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <vector>

#include "jounce/spec/spec.hpp"

/// From what a spec says of motions over time to the motions. All throw InputError, whose keys are
/// those of the document.
namespace jounce::detail {

/// [move]. That there is no such move is bad input here: the spec asks for it.
Trajectory motion_of(const MoveSpec& move);

/// [[command]]; the labels say which segment belongs to which command.
struct QueueMotion {
  Trajectory curve;
  std::vector<std::string> labels;
};
QueueMotion motion_of(const QueueSpec& queue);

/// [[axis]]: one motion each, over one interval.
std::vector<Trajectory> motions_of(const AxesSpec& axes);

/// The motions behind the operators, one after another; all axes together. A unit of time has
/// `unit` seconds. Answers how far each motion may be, with its derivatives, from what the operators
/// say: where they had to be fitted.
std::vector<Jet> apply(std::span<const Operator> then, std::span<const AxisPart> parts, double unit,
                       std::vector<Trajectory>& motions);

/// A motion that may begin or end moving, which is what was asked for: where it does, it does not
/// hold outside (nothing stands still there) but refuses.
Trajectory moving_at_ends(const Trajectory& motion);

}  // namespace jounce::detail
