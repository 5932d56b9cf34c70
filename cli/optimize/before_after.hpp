// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "jounce/plot/figure.hpp"
#include "jounce/spec/spec.hpp"

namespace jounce::cli {

/// A cam over a paler one of before: position and derivatives by master, and the torque of its [load]
/// where there is one.
Figure before_after(const Spec& before, const Spec& after);

}  // namespace jounce::cli
