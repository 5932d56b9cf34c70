// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <vector>

#include "jounce/spec/spec.hpp"

/// Makes motions from the specs of motions over time. All functions throw InputError with keys of
/// the document.
namespace jounce::design_detail {

/// The motion of [move]. Throws InputError if no such move exists.
Trajectory motion_of(const MoveSpec& move);

/// The motion of [[command]]; the labels name the command of each segment.
struct QueueMotion {
  Trajectory curve;
  std::vector<std::string> labels;
};
QueueMotion motion_of(const QueueSpec& queue);

/// The motions of [[axis]], one for each, over one interval.
std::vector<Trajectory> motions_of(const AxesSpec& axes);

/// Applies the operators, one after another, to the motions of all axes. `unit`: seconds in one
/// unit of time. If motions were fitted, returns for each the greatest distance of the motion and
/// its derivatives from the exact result.
std::vector<Jet> apply(std::span<const Operator> then, std::span<const AxisPart> parts, double unit,
                       std::vector<Trajectory>& motions);

/// A motion that may begin or end in motion. If it does, it refuses times outside, because the axis
/// does not stand still there.
Trajectory moving_at_ends(const Trajectory& motion);

}  // namespace jounce::design_detail
