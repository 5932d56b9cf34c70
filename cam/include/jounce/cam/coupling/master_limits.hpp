// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <string>

#include "jounce/profiles/curve/curve.hpp"
#include "jounce/profiles/limits/limits.hpp"

namespace jounce {

/// Limits of the master at the same time, in magnitude: m/s^2, m/s^3; both >= 0.
struct MasterRates {
  double acceleration = 0;
  double jerk = 0;
};

/// The limit of the master, and the slave's quantity that sets it.
struct MasterLimit {
  double value = std::numeric_limits<double>::infinity();  ///< m/s, or m/s^2; infinite: no limit
  std::string quantity =
      {};            ///< quantity of the slave: "velocity", "acceleration", "jerk"; "" if infinite
  double where = 0;  ///< master position (m) at which the slave is at that limit
};

/// Greatest speed of the master, from the limits of the slave over time.
///
///     Limits slave{.velocity = 2, .acceleration = 40, .jerk = 4000};   // u/s, u/s^2, u/s^3
///     MasterLimit steady = greatest_master_velocity(cam, slave);
///     MasterLimit live = greatest_master_velocity(cam, slave, {.acceleration = 0.5});
///     MasterLimit ramp = greatest_master_acceleration(cam, slave, 1.2);
///
/// For the cam f over a master at speed w, acceleration a and jerk j, the slave has
///
///     (1)  f' w,   f'' w^2 + f' a,   f''' w^3 + 3 f'' w a + f' j
///
/// The result is the greatest w (or a) at which no position of the cam and no sign of a and j
/// exceeds a limit. Exact: every maximum over the cam is an isolated extremum (see roots.hpp),
/// nothing is sampled; accurate to about 1e-12. A step of f (inside, or at the wrap) permits no
/// speed under any limit; a step of f' permits none under a limit of acceleration or jerk; a step
/// of f'' permits none under a limit of jerk. The value is then 0 and `where` the step (beyond 1e-9
/// of the travel, of the derivative's peak, as in `rises`). Omitted limits do not limit; position
/// limits are ignored.
///
/// A value of 0 also means that the master's own rates already exceed a limit. Throws InputError
/// for a limit that is not positive, and rates or a velocity that are negative or not finite.
MasterLimit greatest_master_velocity(const Cam& cam, const Limits& slave,
                                     const MasterRates& rates = {});

/// The greatest acceleration or deceleration (in magnitude) of a master that runs at `velocity`
/// (m/s, >= 0, in either direction), anywhere on the cam, while its jerk is at most `jerk` (m/s^3).
MasterLimit greatest_master_acceleration(const Cam& cam, const Limits& slave, double velocity,
                                         double jerk = 0);

}  // namespace jounce
