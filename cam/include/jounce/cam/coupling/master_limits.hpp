// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <string>

#include "jounce/profiles/curve/curve.hpp"
#include "jounce/profiles/limits/limits.hpp"

namespace jounce {

/// Greatest acceleration and jerk that the master may have at the speed that a function computes or
/// checks: magnitudes, >= 0. u is the slave's unit, m the master's.
struct MasterRates {
  double acceleration = 0;  ///< m/s^2
  double jerk = 0;          ///< m/s^3
  /// Time (s) within which a step of the slave may pass: the cycle of its controller. 0: no speed
  /// permits a step.
  double cycle = 0;
};

/// A limit of the master, and the quantity of the slave that sets it.
struct MasterLimit {
  double value = std::numeric_limits<double>::infinity();  ///< m/s or m/s^2; infinite: no limit
  /// "velocity", "acceleration" or "jerk" of the slave; "" if the value is infinite.
  std::string quantity = {};
  double where = 0;      ///< master position (m) at which the slave reaches its limit
  bool is_step = false;  ///< true: a step of the cam sets the limit (see below)
};

/// Returns the greatest speed of the master at which the slave stays within its limits.
///
///     Limits slave{.velocity = 2, .acceleration = 40, .jerk = 4000};   // u/s, u/s^2, u/s^3
///     MasterLimit steady = greatest_master_velocity(cam, slave);
///     MasterLimit live = greatest_master_velocity(cam, slave, {.acceleration = 0.5});
///     MasterLimit ramp = greatest_master_acceleration(cam, slave, 1.2);
///
/// If the master has speed w, acceleration a and jerk j, the derivatives of the slave are, for the
/// cam f,
///
///     (1)  f' w,   f'' w^2 + f' a,   f''' w^3 + 3 f'' w a + f' j
///
/// The result is the greatest w at which these values exceed no limit, for any position on the cam,
/// and for every sign of a and j. Exact, not sampled: every maximum over the cam is an exact
/// extremum (see extrema.hpp). The error is about 1e-12.
///
/// **Steps.** No speed is permitted in these cases: f steps (inside, or at the end of a period) and
/// any limit is given; f' steps and acceleration or jerk has a limit; f'' steps and the jerk has a
/// limit. The value is then 0, and `where` is the position of the step. A step counts if it exceeds
/// 1e-9 of the travel or of the derivative's peak, as in rises() (design/rise.hpp).
///
/// A controller computes a new setpoint in each cycle T = `rates.cycle`, and a step takes one
/// cycle. With T > 0, a step s of f' or f'' is permitted if the speed w satisfies, with the limits
/// A of the acceleration and J of the jerk,
///
///     (3)  s w <= A T   (f' steps),      s w^2 <= J T   (f'' steps)
///
/// The value is also 0 if the given acceleration and jerk of the master alone cause the slave to
/// exceed a limit. Omitted limits do not apply; position limits are ignored. Throws InputError if a
/// limit is not positive, or if a rate of the master is negative or not finite.
MasterLimit greatest_master_velocity(const Cam& cam, const Limits& slave,
                                     const MasterRates& rates = {});

/// Returns the greatest acceleration or deceleration (magnitude, m/s^2) that a master may have
/// while it runs at `velocity` (m/s, >= 0, in either direction), at any position on the cam.
/// Requires that its jerk is at most `jerk` (m/s^3). The value is 0 if the slave exceeds a limit at
/// this velocity and jerk alone. Steps within one `cycle` (s) and errors: as for
/// greatest_master_velocity().
MasterLimit greatest_master_acceleration(const Cam& cam, const Limits& slave, double velocity,
                                         double jerk = 0, double cycle = 0);

}  // namespace jounce
