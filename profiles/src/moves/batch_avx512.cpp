// SPDX-License-Identifier: Apache-2.0
#include "profiles/src/moves/batch_kernel.hpp"

namespace jounce::profiles_detail {

const Kernels kernels_avx512{each_way<Vector8>, each_rest<Vector8>};

}  // namespace jounce::profiles_detail
