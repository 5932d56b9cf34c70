// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "jounce/validate/drive.hpp"

namespace jounce::validate_detail {

/// Returns the report of a run against its limits. `end`: end of the reference, s.
Report drive_report(const DriveResult& result, const Drive& drive, const DriveOptions& options,
                    double end);

/// Throws InputError for a sync interval that is not within the reference.
void require_within(const DriveOptions& options, double start, double end);

}  // namespace jounce::validate_detail
