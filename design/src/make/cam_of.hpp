// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "jounce/spec/spec.hpp"

namespace jounce::design_detail {

/// The cam of a spec. Derivatives that its knots omit follow the rules of the spec.
CamSpec cam_of(const Spec& spec);

}  // namespace jounce::design_detail
