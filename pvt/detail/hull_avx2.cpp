#include "jounce/pvt/detail/hull_kernel.hpp"

namespace jounce::detail {

void hulls_avx2(const KnotColumns& t, Rule rule, std::size_t first, std::size_t n, Hulls& out) {
  hulls_in<Vector4>(t, rule, first, n, out);
}

}  // namespace jounce::detail
