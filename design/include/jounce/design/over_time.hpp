// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "jounce/design/input.hpp"

namespace jounce {

/// Returns the slave of a cam as a motion over the spec's unit of time, for the [master] of the
/// spec. Its limits are [limits.slave]; its sync zones are the times at which the master passes the
/// sync zones of the cam (no zones if there would be more than about 200). The result has no spec.
/// Exact, or within 1e-9 of the stroke. Throws InputError for a motion over time, for a table, and
/// for a spec without [master].
Input over_time(const Input& input);

}  // namespace jounce
