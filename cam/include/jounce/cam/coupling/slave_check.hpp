// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "jounce/cam/coupling/master_limits.hpp"

namespace jounce {

/// Checks velocity, acceleration and jerk of a cam's slave against its limits over time. The master
/// runs at `velocity` (m/s, > 0) and accelerates or brakes with at most `rates`, anywhere on the
/// cam. u is the slave's unit, m the master's. Equation (1) in master_limits.hpp gives the checked
/// values.
///
///     Report report = check_slave(cam, {.acceleration = 15000}, 720);  // mm/s^2, deg/s
///
/// The findings have the rules `limit/velocity`, `limit/acceleration` and `limit/jerk`, like the
/// findings of check(). Values and limits are in u/s, u/s^2, u/s^3; `where` is a master position.
/// Exact, as in greatest_master_velocity(). At a step of the cam a derivative is infinite;
/// check_continuity() reports the step. Position limits are ignored. Throws InputError for a limit
/// or a velocity that is not positive, and for negative rates.
Report check_slave(const Cam& cam, const Limits& slave, double velocity,
                   const MasterRates& rates = {});

}  // namespace jounce
