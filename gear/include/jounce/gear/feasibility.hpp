// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "jounce/cam/coupling/master_limits.hpp"
#include "jounce/gear/sync_cam.hpp"
#include "jounce/profiles/limits/limits.hpp"

namespace jounce {

/// Motion of the master of a gear: velocities up to `velocity` (m/s, > 0, in either direction),
/// with acceleration and jerk up to `rates`. m is the master's unit.
struct MasterRange {
  double velocity = 0;     ///< m/s
  MasterRates rates = {};  ///< m/s^2, m/s^3
};

/// Checks whether a slave in step with its master stays within its limits over time, at every speed
/// of the master in the range.
///
///     const SyncCam slave = gear_course(course);
///     Report report = feasibility(slave.cam, {.velocity = 50, .acceleration = 0.1}, {.velocity = 100});
///     for (const Finding& f : report.findings)
///       if (f.broken) ...   // f.quantity "acceleration", f.where 0 m, f.advice "at most 44.7 m/s"
///
/// Returns one finding for each given limit: "feasible/velocity", "feasible/acceleration",
/// "feasible/jerk". `value` is the master's greatest velocity, `limit` the greatest velocity at
/// which the slave stays within this limit, and `where` the master position at which the slave
/// reaches the limit. Exact (jounce/cam/coupling/master_limits.hpp). All terms grow with the
/// master's speed, so it is enough to check the greatest speed. Throws InputError if a limit or the
/// range is invalid.
Report feasibility(const Cam& cam, const Limits& slave, const MasterRange& master);

}  // namespace jounce
