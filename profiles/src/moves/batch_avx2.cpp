// SPDX-License-Identifier: Apache-2.0
#include "profiles/src/moves/batch_kernel.hpp"

namespace jounce::profiles_detail {
namespace {

void ways(Block& block) noexcept {
  each_way<Vector4>(block);
}
void rests(Block& block) noexcept {
  each_rest<Vector4>(block);
}

}  // namespace

const Kernels kernels_avx2{ways, rests};

}  // namespace jounce::profiles_detail
