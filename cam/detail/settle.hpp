#pragma once

#include "jounce/cam/coupling.hpp"

namespace jounce::detail {

/// Brings the slave onto a cam that lies where `placement` says, by a start mode whose numbers the
/// coupling has.
Engagement settle(const Coupling& coupling, StartMode start, const Placement& placement,
                  const MotionState& slave, const Jet& master, double t);

/// Whether the coupling has what a start mode needs.
bool has_numbers(const CouplingSpec& spec, StartMode start);

}  // namespace jounce::detail
