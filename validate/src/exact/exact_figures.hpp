// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "jounce/validate/linear_drive.hpp"

namespace jounce::validate_detail {

/// The certified figures of a linear drive with a continuous controller along a reference; none where the
/// demanded torque may exceed its limit. Without samples and report.
std::optional<DriveResult> exact_figures(const Trajectory& reference, const Drive& drive,
                                         const DriveOptions& options);

}  // namespace jounce::validate_detail
