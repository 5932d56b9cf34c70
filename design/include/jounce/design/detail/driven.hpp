// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "jounce/design/input.hpp"
#include "jounce/validate/drive.hpp"

namespace jounce {

/// Simulates the input's table with the [drive] of its spec. Requires a spec with [drive]. In each
/// finding, `axis` is "drive", `where` is a time in s, and `unit` and `where_unit` are set.
/// `samples` is the number of points of the result; 0: none. Throws InputError if a cam has no
/// [master].
DriveResult driven(const Input& input, std::size_t samples = 0);

/// Adds the peak torque that the motion needs without torque_limit to the advice of a broken
/// finding "drive/saturation", for which it simulates the drive once more. `result`: driven(input).
void add_torque_demand(DriveResult& result, const Input& input);

}  // namespace jounce
