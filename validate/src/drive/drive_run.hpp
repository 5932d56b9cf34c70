// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "jounce/validate/drive.hpp"

namespace jounce::validate_detail {

struct DriveRun {
  DriveResult result;         ///< without the report
  std::vector<double> state;  ///< state of DriveModel, where it ended
};

/// The run of drive_through, for drive and options that have been checked: from rest, or, where `start` is not
/// empty, from these states of DriveModel with the reference moving as its first piece does.
DriveRun run(const SignalView& reference, const Drive& drive, const DriveOptions& options,
             const std::vector<double>& start = {});

}  // namespace jounce::validate_detail
