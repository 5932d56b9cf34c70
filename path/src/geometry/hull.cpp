// SPDX-License-Identifier: Apache-2.0
#include "path/src/geometry/hull.hpp"

#include <algorithm>
#include <array>

namespace jounce {

std::pair<double, double> hull_of_products(std::span<const Segment> f, std::span<const Segment> g) {
  std::array<double, 2 * Segment::max_degree + 1> b{};
  std::size_t n = 0;
  for (std::size_t axis = 0; axis < f.size(); ++axis) {
    const auto first = static_cast<std::size_t>(f[axis].degree);
    const auto second = static_cast<std::size_t>(g[axis].degree);
    n = std::max(n, first + second);
    for (std::size_t i = 0; i <= first; ++i)
      for (std::size_t k = 0; k <= second; ++k) b[i + k] += f[axis].c[i] * g[axis].c[k];
  }
  double binomial = 1;
  for (std::size_t k = 0; k <= n; ++k) {
    b[k] /= binomial;
    binomial = binomial * static_cast<double>(n - k) / static_cast<double>(k + 1);
  }
  for (std::size_t k = 1; k <= n; ++k)
    for (std::size_t i = n; i >= k; --i) b[i] += b[i - 1];
  const auto [low, high] =
      std::minmax_element(b.begin(), b.begin() + static_cast<std::ptrdiff_t>(n) + 1);
  return {*low, *high};
}

std::pair<double, double> hull_of_speed_squared(std::span<const Segment> axes) {
  std::array<Segment, 9> slope;
  for (std::size_t i = 0; i < axes.size(); ++i) slope[i] = derivative(axes[i]);
  const auto slopes = std::span<const Segment>(slope).first(axes.size());
  return hull_of_products(slopes, slopes);
}

}  // namespace jounce
