// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "jounce/validate/linear_drive.hpp"

namespace jounce::detail {

/// What a linear drive with a continuous controller does along a reference, its figures certified; nothing
/// where the torque asked for may pass its limit. Neither samples nor report.
std::optional<DriveResult> exact_figures(const Trajectory& reference, const Drive& drive,
                                         const DriveOptions& options);

}  // namespace jounce::detail
