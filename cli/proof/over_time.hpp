// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "cli/common/input.hpp"

namespace jounce::cli {

/// A cam as its slave moves behind the [master] of its spec: a motion over the spec's time unit, with
/// [limits.slave], and the zones at the times at which the master passes them. Exact, or within
/// 1e-9 of the stroke. Throws InputError for what is no spec of a cam with a [master].
Input over_time(const Input& input);

}  // namespace jounce::cli
