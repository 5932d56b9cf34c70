// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "jounce/validate/linear_drive.hpp"

namespace jounce::validate_detail {

/// Returns the proven figures of a linear drive with a continuous controller along a reference,
/// without samples and report; nullopt if the required torque may exceed its limit.
std::optional<DriveResult> exact_figures(const Trajectory& reference, const Drive& drive,
                                         const DriveOptions& options);

}  // namespace jounce::validate_detail
