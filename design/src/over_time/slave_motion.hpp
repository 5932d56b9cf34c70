// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "jounce/design/input.hpp"
#include "jounce/profiles/curve/fitted.hpp"

namespace jounce::design_detail {

/// Returns the slave of a cam as a motion over the spec's unit of time, like motion_over_time(),
/// with the error of the fit. Requires a cam.
Fitted<OverTime> slave_motion(const Input& input);

}  // namespace jounce::design_detail
