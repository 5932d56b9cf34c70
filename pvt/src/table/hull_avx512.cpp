// SPDX-License-Identifier: Apache-2.0
#include "pvt/src/table/hull_kernel.hpp"

namespace jounce::pvt_detail {

void hulls_avx512(const KnotColumns& t, Interpolation rule, std::size_t first, std::size_t n,
                  Hulls& out) {
  hulls_in<profiles_detail::Vector8>(t, rule, first, n, out);
}

}  // namespace jounce::pvt_detail
