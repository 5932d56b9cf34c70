#pragma once

#include "jounce/io/spec.hpp"

namespace jounce::detail {

/// The cam of a spec with what its knots leave out chosen as the spec says.
CamSpec cam_of(const Spec& spec);

}  // namespace jounce::detail
