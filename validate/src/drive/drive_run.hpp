// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "jounce/validate/drive.hpp"

namespace jounce::validate_detail {

/// Result of run().
struct DriveRun {
  DriveResult result;         ///< the result without its report
  std::vector<double> state;  ///< states of DriveModel at the end
};

/// Runs drive_through() for a drive and options that are valid. The run begins at rest; if `start`
/// is not empty, it begins with these states of DriveModel and with the motion of the first piece.
DriveRun run(const SignalView& reference, const Drive& drive, const DriveOptions& options,
             const std::vector<double>& start = {});

}  // namespace jounce::validate_detail
