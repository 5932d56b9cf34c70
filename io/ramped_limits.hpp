#pragma once

#include "jounce/io/spec.hpp"
#include "jounce/optimize/ramped.hpp"

namespace jounce {

/// [limits.slave] of a cam spec while the master accelerates as [master] states; none without [master].
RampedLimits ramped_limits(const Spec& spec);

}  // namespace jounce
