// SPDX-License-Identifier: Apache-2.0
#include "profiles/src/moves/batch_kernel.hpp"

namespace jounce::profiles_detail {

const Kernels kernels_anywhere{each_way<Vector2>, each_rest<Vector2>};

}  // namespace jounce::profiles_detail
