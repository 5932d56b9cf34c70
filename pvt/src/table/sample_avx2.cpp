// SPDX-License-Identifier: Apache-2.0
#include "pvt/src/table/sample_kernel.hpp"

namespace jounce::pvt_detail {

const SampleKernels sample_avx2 = kernels_of<profiles_detail::Vector4>();

}  // namespace jounce::pvt_detail
