// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "jounce/design/input.hpp"

namespace jounce::design_detail {

/// Gives each broken limit of a derivative of a cam an advice with numbers: the length with which its
/// segment keeps all its limits, and a law that keeps them, if there is one. If the cam is too short
/// for these lengths together, the advice is the least possible limit. Requires input.spec.
void advise_on_cam(const Input& input, Report& report);

}  // namespace jounce::design_detail
