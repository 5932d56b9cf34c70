// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "jounce/path/plan.hpp"

namespace jounce {

/// The part in which two plans of a group are equal. q is the length along the path.
struct Agreement {
  double position = 0;  ///< q of the first plan at which the second plan begins
  double shift = 0;     ///< time of the first plan at which the second plan begins, s; may be < 0
  double until = 0;     ///< time of the first plan up to which both plans are equal, s
};

/// Compares two plans: `before`, which a group plays, and `after`, the plan of a longer program.
/// The longer program contains the commands of the first program and further commands. Commands at
/// the beginning may be missing if the group has passed them. A command has the same source line
/// number in both programs. A planner with look-ahead changes only the motion after the place where
/// the group brakes for the end of its program. So a group can change to the second plan before
/// that place.
///
/// `q`: present place of the group on the path of `before`. From there to the time `until`, both
/// plans are equal to rounding: the state of `before` at the time t is the state of `after` at the
/// time t - shift. Returns nullopt if the plans differ at q. The duration of the call is
/// proportional to the number of pieces of both plans.
std::optional<Agreement> agreement(const Plan& before, const Plan& after, double q);

}  // namespace jounce
