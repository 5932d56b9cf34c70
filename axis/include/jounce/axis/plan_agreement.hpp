// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "jounce/path/plan.hpp"

namespace jounce {

/// The times at which one plan equals another.
struct Agreement {
  double position = 0;  ///< q of the first plan at which the second plan begins
  double shift = 0;     ///< time of the first plan at which the second plan begins, s; may be < 0
  double until = 0;     ///< time of the first plan up to which both are equal, s
};

/// Compares the plan `before`, which a group plays, with a plan `after` of a longer program. The
/// second program contains the commands of the first one, or their end from a command that was
/// passed, and further commands. Both use the same numbers as source lines. A planner with
/// look-ahead changes only what comes after the place where the group brakes for the end of its
/// program, so a group can change to the second plan before that place.
///
/// `q`: present place of the group on the path of `before`. Both plans are equal to rounding from
/// there to `until`: at the time t of `before`, at the time t - shift of `after`. Returns nullopt if
/// they differ at q. The duration of the call is proportional to the number of pieces.
std::optional<Agreement> agreement(const Plan& before, const Plan& after, double q);

}  // namespace jounce
