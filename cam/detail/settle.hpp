#pragma once

#include "jounce/cam/coupling.hpp"

namespace jounce::detail {

/// Brings the slave onto a cam that lies where `placement` says, by the coupling's start mode.
Engagement settle(const Coupling& coupling, const Placement& placement, const MotionState& slave,
                  const Jet& master, double t);

}  // namespace jounce::detail
