// SPDX-License-Identifier: Apache-2.0
#include "jounce/study/detail/sample_design.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>
#include <numeric>
#include <utility>

#include "jounce/profiles/error.hpp"

#include "study/src/sweep/counter_random.hpp"
#include "study/src/sweep/sobol.hpp"

namespace jounce {
namespace {

/// 0 ... n - 1 in the order of random numbers.
std::vector<std::uint32_t> permutation(const Draw& stream, std::size_t n) {
  std::vector<double> keys(n);
  for (std::size_t i = 0; i < n; ++i) keys[i] = uniform({stream.seed, stream.stream, i});
  std::vector<std::uint32_t> order(n);
  std::iota(order.begin(), order.end(), 0U);
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    return std::pair(keys[a], a) < std::pair(keys[b], b);
  });
  return order;
}

}  // namespace

SampleDesign::SampleDesign(Design design, std::uint64_t seed, std::vector<std::string> names,
                           std::size_t samples)
    : design_(design), seed_(seed), names_(std::move(names)) {
  if (design == Design::sobol && names_.size() > sobol_dimensions)
    throw InputError("design", "\"sobol\"",
                     "takes at most " + std::to_string(sobol_dimensions) +
                         " random parameters; there are " + std::to_string(names_.size()));
  if (design != Design::latin_hypercube) return;
  for (const std::string& name : names_)
    order_.push_back(permutation({seed, stream_of(name + " order"), 0}, samples));
}

double SampleDesign::at(std::size_t parameter, std::size_t sample) const {
  assert(design_ != Design::random);
  const std::uint64_t stream = stream_of(names_[parameter]);
  if (design_ == Design::latin_hypercube) {
    const auto& order = order_[parameter];
    return (order[sample] + uniform({seed_, stream, sample})) / static_cast<double>(order.size());
  }
  const double shift = std::floor(uniform({seed_, stream, 0}) * 0x1p32);
  const std::uint32_t x =
      sobol(static_cast<std::uint32_t>(sample), parameter) ^ static_cast<std::uint32_t>(shift);
  return (x + 0.5) * 0x1p-32;
}

double normal_quantile(double u) {
  if (u > 0.5) return -normal_quantile(1 - u);
  double low = -40, high = 0;
  for (int i = 0; i < 60; ++i) {
    const double middle = (low + high) / 2;
    (std::erfc(-middle / std::numbers::sqrt2) / 2 < u ? low : high) = middle;
  }
  return (low + high) / 2;
}

}  // namespace jounce
