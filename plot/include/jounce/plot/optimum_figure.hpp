// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "jounce/plot/figure.hpp"
#include "jounce/spec/spec.hpp"

namespace jounce {

/// Returns the motion of an optimized spec over the pale motion of the given spec: position and
/// derivatives and, if the spec has a [load], the torque. Requires specs of one axis.
Figure optimum_figure(const Spec& given, const Spec& optimized);

}  // namespace jounce
