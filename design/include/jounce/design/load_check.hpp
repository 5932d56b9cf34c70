// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "jounce/spec/spec.hpp"

namespace jounce {

/// The motor's torque by [load] at the velocity of [master], against [load.limits]: findings
/// `limit/load_torque`, at the curve's worst place, and `limit/load_rms_torque`. The peak is exact; a
/// lever's sine makes it miss 1e-8 of itself. The rms is a quadrature to about 1e-10. Empty without limits.
Report check_load(const Spec& spec, const Cam& cam);

}  // namespace jounce
