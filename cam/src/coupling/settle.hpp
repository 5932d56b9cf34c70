// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "jounce/cam/coupling/coupling.hpp"

namespace jounce::detail {

/// Brings the slave onto a cam that lies where `placement` says, by a start mode whose numbers the
/// coupling has.
Engagement settle(const Coupling& coupling, StartMode start, const Placement& placement,
                  const MotionState& slave, const Jet& master, double t);

/// True if the coupling has what a start mode needs.
bool has_numbers(const CouplingSpec& spec, StartMode start);

/// Differences in position, velocity and acceleration that are rounding: between a slave and its cam's
/// y, behind a master that moves as x. 1e-9 of what they can reach; of a position far out, 1e-12 of
/// itself.
Jet roundings(const Coupling& coupling, const MotionState& slave, const Jet& y, const Jet& x);

}  // namespace jounce::detail
