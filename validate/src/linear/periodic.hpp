// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "jounce/validate/drive.hpp"

#include "validate/src/exact/exact_path.hpp"

namespace jounce::validate_detail {

/// Returns the state of a linear drive (scaled as the given system) at the beginning of each period
/// of an endless reference: right after the step from the end of a period to its start. Throws
/// InputError if the loops do not decay.
Eigen::VectorXd periodic_start(const LinearSystem& system, const Trajectory& period,
                               const Drive& drive);

/// Returns the state at the start of a run: at rest, or the state of periodic_start().
PathStart path_start(const LinearSystem& system, const Trajectory& reference, const Drive& drive,
                     bool periodic);

/// Throws InputError with the reason for a drive whose steady state is not computed: one that is
/// not linear, or whose controller has a cycle.
void require_steady(const Drive& drive);

/// Returns a result without a run if the loop is unstable, so that there is no steady state. Its
/// report has only the finding "drive/stability". Returns nullopt if the loop is stable.
std::optional<DriveResult> without_steady_state(const Drive& drive, double start);

/// Returns the state of periodic_start() as the states of DriveModel.
std::vector<double> periodic_model_start(const Trajectory& period, const Drive& drive);

}  // namespace jounce::validate_detail
