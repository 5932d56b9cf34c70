// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "jounce/validate/identify.hpp"

namespace jounce {

/// A recorded run from a CSV file (its form: points.hpp), in seconds, N m and the unit of the drive's
/// position:
///
///     time [ms],command [deg],feedback [deg],current [A]
///     0,0,0.01,0.02
///
/// `time` and `command` are required, and at least one of `feedback` (of the motor's encoder, in
/// the same unit as the command), `velocity`, `torque`, `current` (times the drive's torque
/// constant) and `load` (an encoder at the last mass). Other columns are ignored. A header without
/// a unit means the unit of the drive's file, seconds, N m, A. Throws InputError with file, line,
/// column and rule for everything that points.hpp rejects, for a missing column, times that do not
/// ascend, and a current without a torque constant.
Recording read_recording(const std::string& path, const Drive& drive, const std::string& position);

}  // namespace jounce
