// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "jounce/spec/spec.hpp"

namespace jounce {

/// The motor's torque by [load] at the velocity of [master], against [load.limits]: findings
/// `limit/load_torque`, at the curve's worst place, and `limit/load_rms_torque`. The peak is exact,
/// or within 1e-8 of its value with the sine of a lever. The rms is a quadrature to about 1e-10.
/// Empty without limits.
Report check_load(const Spec& spec, const Cam& cam);

}  // namespace jounce
