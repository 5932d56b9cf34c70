// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "jounce/cam/coupling/master_limits.hpp"

namespace jounce {

/// Checks the slave of a cam over time against its limits, while the master runs at `velocity`
/// (m/s, > 0) and accelerates or brakes with at most `rates`, anywhere on the cam: velocity,
/// acceleration and jerk by (1) of master_limits.hpp.
///
///     Report report = check_slave(cam, {.acceleration = 15000}, 720);  // mm/s^2, deg/s
///
/// The findings are those of check(), of the rules `limit/velocity`, `limit/acceleration` and `limit/jerk`: values and
/// limits in u/s, u/s^2, u/s^3, places on the master. Exact, as in greatest_master_velocity(). A step of the cam has no
/// finite rate: check_continuity() reports it. Position limits are ignored. Throws InputError for a limit or a velocity
/// that is not positive, and for negative rates.
Report check_slave(const Cam& cam, const Limits& slave, double velocity,
                   const MasterRates& rates = {});

}  // namespace jounce
