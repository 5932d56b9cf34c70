// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "jounce/plot/figure.hpp"
#include "jounce/spec/spec.hpp"

namespace jounce {

/// The motion of an optimized spec over the paler one of the given spec: position and derivatives,
/// and the torque of its [load] if there is one. Both specs have one axis.
Figure optimum_figure(const Spec& given, const Spec& optimized);

}  // namespace jounce
