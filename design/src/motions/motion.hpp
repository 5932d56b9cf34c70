// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <vector>

#include "jounce/spec/spec.hpp"

/// From the specs of motions over time to the motions. All functions throw InputError with keys of the document.
namespace jounce::design_detail {

/// The motion of [move]. Throws InputError if no such move exists.
Trajectory motion_of(const MoveSpec& move);

/// [[command]]; the labels name the command of each segment.
struct QueueMotion {
  Trajectory curve;
  std::vector<std::string> labels;
};
QueueMotion motion_of(const QueueSpec& queue);

/// [[axis]]: one motion each, over one interval.
std::vector<Trajectory> motions_of(const AxesSpec& axes);

/// The motions after the operators, which are applied one after another to all axes. A unit of time has `unit` seconds.
/// Returns the greatest distance of each motion and its derivatives from the exact result, where a result was fitted.
std::vector<Jet> apply(std::span<const Operator> then, std::span<const AxisPart> parts, double unit,
                       std::vector<Trajectory>& motions);

/// A motion that may begin or end moving. If it does, it refuses times outside: the axis does not stand there.
Trajectory moving_at_ends(const Trajectory& motion);

}  // namespace jounce::design_detail
