// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "jounce/design/input.hpp"

namespace jounce::design_detail {

/// True if the curve begins beyond the limit of the position that the finding breaks.
bool begins_beyond(const Trajectory& curve, const Finding& f);

/// Keeps the worst finding of each excursion beyond a limit of the position. An excursion may take
/// several pieces: it goes on where the curve is beyond the limit at their joint.
void join_excursions(const Input& input, Report& report);

/// Adds the first passage of a limit of the position to its worst finding: there, the soft limit of a
/// controller stops the axis (Googol manual, example 9-1).
void name_first_passages(const Input& input, Report& report);

}  // namespace jounce::design_detail
