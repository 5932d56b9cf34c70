// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "jounce/design/input.hpp"

namespace jounce::design_detail {

/// The cycle (tick) of the executor by default, in this unit of time. A limit of the jerk permits a
/// step of the acceleration by jerk * cycle, and a limit of the acceleration a step of the velocity
/// by acceleration * cycle (docs/executor/playing.md).
double usual_cycle(const std::string& time_unit);

/// Findings `limit/acceleration_step` and `limit/velocity_step` for steps of the motion over time
/// that the limits do not permit within one cycle: those of the curve, and those of its table if the
/// curve has none. Permitted steps of a linear table are notes, and those of a planned path. A cam
/// moves over time behind the [master] of its spec. `found`: the findings so far; a curve whose
/// velocity steps gets no finding.
Report check_steps(const Input& input, const Report& found);

/// True for a table of straight lines from a curve whose velocity does not step: the steps of its
/// velocity belong to the rule, and check_steps() compares them with the limit of the acceleration.
bool is_lines_of_a_smooth_curve(const Input& input);

}  // namespace jounce::design_detail
