// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cassert>

#include "jounce/profiles/error.hpp"
#include "jounce/pvt/table.hpp"

#include "pvt/src/table/sample_kernel.hpp"

// A block is divided where the samples enter and leave the table. Samples inside go to the widest
// kernel of the processor. Samples outside, which are rare, go one by one to jet(), which applies
// the policy. So do all samples of a block that does not ascend.

namespace jounce {
namespace {

using pvt_detail::Samples;

void one_by_one(const Table& table, const auto& at, std::size_t first, std::size_t last,
                Samples out) {
  for (std::size_t k = first; k < last; ++k) {
    const Jet f = table.jet(at.at(k));
    out.p[k] = f[0];
    out.v[k] = f[1];
    out.a[k] = f[2];
  }
}

template <class Instants>
std::size_t first_not_before(const Instants& at, double bound, std::size_t low, std::size_t high) {
  return pvt_detail::first_after([&](std::size_t k) { return at.at(k) < bound; }, low, high, low);
}

/// Evaluates `size` ascending samples.
template <class Instants>
void sample_block(const Table& table, const Instants& at, std::size_t size, Samples out,
                  void (*kernel)(const pvt_detail::KnotColumns&, Interpolation, Instants,
                                 std::size_t, std::size_t, Samples)) {
  const std::size_t enters = first_not_before(at, table.start(), 0, size);
  const std::size_t leaves = first_not_before(at, table.end(), enters, size);
  one_by_one(table, at, 0, enters, out);
  if (enters < leaves)
    kernel(pvt_detail::knots_of(table.columns()), table.rule(), at, enters, leaves, out);
  one_by_one(table, at, leaves, size, out);
}

}  // namespace

const pvt_detail::SampleKernels& pvt_detail::sample_kernels() {
#ifdef JOUNCE_WIDE_KERNELS
  static const SampleKernels& best = __builtin_cpu_supports("avx512f") ? sample_avx512
                                     : __builtin_cpu_supports("avx2")  ? sample_avx2
                                                                       : sample_anywhere;
  return best;
#else
  return sample_anywhere;
#endif
}

void Table::sample(std::span<const double> x, std::span<double> p, std::span<double> v,
                   std::span<double> a) const {
  require_size("p", p.size(), x.size());
  require_size("v", v.size(), x.size());
  require_size("a", a.size(), x.size());
  const pvt_detail::Listed at{x.data()};
  const Samples out{p.data(), v.data(), a.data()};
  const pvt_detail::SampleKernels& kernels = pvt_detail::sample_kernels();
  if (!kernels.ascends(x.data(), x.size())) return one_by_one(*this, at, 0, x.size(), out);
  sample_block(*this, at, x.size(), out, kernels.listed);
}

void Table::sample(const Grid& grid, std::span<double> p, std::span<double> v,
                   std::span<double> a) const {
  assert(grid.step > 0);
  require_size("v", v.size(), p.size());
  require_size("a", a.size(), p.size());
  sample_block(*this, pvt_detail::Uniform{grid.start, grid.step}, p.size(),
               {p.data(), v.data(), a.data()}, pvt_detail::sample_kernels().uniform);
}

}  // namespace jounce
