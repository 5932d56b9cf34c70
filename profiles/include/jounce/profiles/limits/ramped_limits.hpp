// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "jounce/profiles/limits/limits.hpp"

namespace jounce {

/// Limits of the slave for a master that also accelerates. Let w be the speed of the master, a its
/// greatest acceleration, and ramp = a / w^2. The limits then are, over the whole cam f,
///
///     |f''| + ramp |f'| <= limits.acceleration,   |f'''| + 3 ramp |f''| <= limits.jerk
///
/// See greatest_master_velocity() in jounce/cam/coupling/master_limits.hpp.
struct RampedLimits {
  double ramp = 0;     ///< a / w^2, 1/m, >= 0; 0: no such limits
  Limits limits = {};  ///< per master unit; only acceleration and jerk are used
};

}  // namespace jounce
