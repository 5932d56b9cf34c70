// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "jounce/validate/linear_drive.hpp"

namespace jounce::validate_detail {

/// exact_run() for a valid linear drive whose controller has a cycle.
ExactRun sampled_run(const Trajectory& reference, const Drive& drive,
                     std::span<const double> times);

}  // namespace jounce::validate_detail
