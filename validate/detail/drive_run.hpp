#pragma once

#include "jounce/validate/drive.hpp"

namespace jounce::detail {

/// The run of drive_through, for drive and options that have been checked, without the report.
DriveResult run(const SignalView& reference, const Drive& drive, const DriveOptions& options);

}  // namespace jounce::detail
