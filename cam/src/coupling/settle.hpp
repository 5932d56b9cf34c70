// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "jounce/cam/coupling/coupling.hpp"

namespace jounce::cam_detail {

/// Brings the slave onto a cam placed by `placement`, by a start mode for which the coupling has
/// the parameters.
Engagement settle(const Coupling& coupling, StartMode start, const Placement& placement,
                  const MotionState& slave, const Jet& master, double t);

/// True if the coupling has the parameters of a start mode.
bool has_numbers(const CouplingSpec& spec, StartMode start);

/// Differences in position, velocity and acceleration that count as rounding, between a slave and
/// the y of its cam, for a master at x. They are 1e-9 of their ranges; for a distant position,
/// 1e-12 of its magnitude.
Jet roundings(const Coupling& coupling, const MotionState& slave, const Jet& y, const Jet& x);

}  // namespace jounce::cam_detail
