// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "jounce/spec/spec.hpp"

namespace jounce::detail {

/// The cam of a spec with what its knots leave out chosen as the spec says.
CamSpec cam_of(const Spec& spec);

}  // namespace jounce::detail
