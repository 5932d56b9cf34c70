// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "jounce/design/input.hpp"

namespace jounce::design_detail {

/// Adds to the broken limits of the slave over time the least peak that any motion of the segment
/// has: from the knot before it to the knot after it, in the same time, within the other limits. One
/// finding of each segment receives the remedy. Segments beside a moving segment keep their advice,
/// because the values at their knots may change.
void advise_on_slave(const Input& input, Report& report);

}  // namespace jounce::design_detail
