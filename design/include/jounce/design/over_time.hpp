// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "jounce/design/input.hpp"

namespace jounce {

/// The slave of a cam as a motion over the spec's time unit, behind the [master] of the spec: with [limits.slave], and
/// with the zones at the times at which the master passes them. Exact, or within 1e-9 of the stroke. Throws InputError
/// for a motion over time, for a table, and for a spec without [master].
Input over_time(const Input& input);

}  // namespace jounce
