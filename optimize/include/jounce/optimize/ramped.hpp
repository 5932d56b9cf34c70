// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "jounce/optimize/optimize.hpp"

namespace jounce {

/// The slave's limits behind a master that also accelerates. With ramp = a / w^2, a the master's greatest
/// acceleration and w its speed,
///
///     |f''| + ramp |f'| <= limits.acceleration,   |f'''| + 3 ramp |f''| <= limits.jerk
///
/// hold over the whole cam, as greatest_master_velocity() has them (jounce/cam/coupling/master_limits.hpp).
struct RampedLimits {
  double ramp = 0;     ///< 1/m, >= 0; 0: no limits of this kind
  Limits limits = {};  ///< per master unit: acceleration and jerk alone are used
};

/// optimize() under these limits, too. They are judged in Outcome::limits and listed in Outcome::active as
/// "limit/ramped_geo_acceleration" and "limit/ramped_geo_jerk". Throws InputError as well for a ramp that is negative
/// or not finite, and as require_valid(limits) does.
Outcome optimize(const CamProblem& problem, const RampedLimits& ramped,
                 const KeepGoing& keep_going = {});

}  // namespace jounce
