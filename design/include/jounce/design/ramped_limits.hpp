// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "jounce/optimize/ramped.hpp"
#include "jounce/spec/spec.hpp"

namespace jounce {

/// [limits.slave] of a cam spec while the master accelerates as [master] states; none without [master].
RampedLimits ramped_limits(const Spec& spec);

}  // namespace jounce
