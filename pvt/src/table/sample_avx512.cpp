// SPDX-License-Identifier: Apache-2.0
#include "pvt/src/table/sample_kernel.hpp"

namespace jounce::pvt_detail {
namespace {

void listed(const KnotColumns& t, Interpolation rule, Listed at, std::size_t first,
            std::size_t last, Samples out) {
  sample_table<profiles_detail::Vector8>(t, rule, at, first, last, out);
}
void uniform(const KnotColumns& t, Interpolation rule, Uniform at,
                              std::size_t first, std::size_t last, Samples out) {
  sample_table<profiles_detail::Vector8>(t, rule, at, first, last, out);
}

bool ascends(const double* x, std::size_t size) {
  return all_ascend<profiles_detail::Vector8>(x, size);
}

}  // namespace

const SampleKernels sample_avx512{listed, uniform, ascends};

}  // namespace jounce::pvt_detail
