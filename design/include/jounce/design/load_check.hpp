// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "jounce/spec/spec.hpp"

namespace jounce {

/// Compares the motor's torque, from [load] and the velocity of [master], with [load.limits].
/// Findings: `limit/load_torque` at the worst place of the curve, and `limit/load_rms_torque`. The
/// peak is exact; with the sine of a lever it is within 1e-8 of its value. The rms is a quadrature
/// with a relative error of about 1e-10. Empty if there are no limits.
Report check_load(const Spec& spec, const Cam& cam);

}  // namespace jounce
