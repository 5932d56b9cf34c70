// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "jounce/executor/executor_options.hpp"
#include "jounce/spec/axis_drive.hpp"

namespace jounce {

/// The drive that a spec names, for an axis with this configuration. Throws InputError, with keys of
/// [drive], and std::system_error where the machine has no shared memory.
std::shared_ptr<AxisDrive> make_drive(const AxisDriveSpec& spec, const AxisConfig& axis);

}  // namespace jounce
