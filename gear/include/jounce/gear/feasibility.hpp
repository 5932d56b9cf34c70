// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "jounce/cam/coupling/master_limits.hpp"
#include "jounce/gear/sync_cam.hpp"
#include "jounce/profiles/limits/limits.hpp"

namespace jounce {

/// Motion of the master of a gear: at up to `velocity` (m/s, > 0, either way), while its acceleration
/// and jerk stay within `rates`.
struct MasterRange {
  double velocity = 0;
  MasterRates rates = {};
};

/// True if a slave in step with its master keeps its limits over time, at every speed of the master
/// up to the greatest one.
///
///     const SyncCam slave = gear_course(course);
///     Report report = feasibility(slave.cam, {.velocity = 50, .acceleration = 0.1}, {.velocity = 100});
///     for (const Finding& f : report.findings)
///       if (f.broken) ...       // f.quantity "acceleration", f.where 0 m, f.advice "at most 44.7 m/s"
///
/// One finding "feasible/velocity", "feasible/acceleration", "feasible/jerk" for each given limit:
/// `value` is the master's greatest velocity, `limit` the greatest one that keeps this limit alone,
/// `where` the master position at which it binds. Exact (jounce/cam/coupling/master_limits.hpp).
/// Each term grows with the speed of the master, so only the greatest speed counts. Throws
/// InputError for limits or a range that are out of range.
Report feasibility(const Cam& cam, const Limits& slave, const MasterRange& master);

}  // namespace jounce
