// SPDX-License-Identifier: Apache-2.0
#include "profiles/src/moves/batch_kernel.hpp"

namespace jounce::profiles_detail {

const Kernels kernels_avx2{each_way<Vector4>, each_rest<Vector4>};

}  // namespace jounce::profiles_detail
