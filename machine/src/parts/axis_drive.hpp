// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "jounce/executor/executor_options.hpp"
#include "jounce/spec/axis_drive.hpp"

namespace jounce {

/// Makes the drive that a spec describes, for an axis with this configuration. Throws InputError
/// with keys of [drive], and std::system_error if the system has no shared memory for it. `opens`
/// false: an ideal drive takes the place of one in shared memory.
std::shared_ptr<AxisDrive> make_drive(const AxisDriveSpec& spec, const AxisConfig& axis,
                                      bool opens = true);

}  // namespace jounce
