// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

namespace jounce {

/// Adds the weighted values of f at the ten Gauss nodes of [middle - half, middle + half] to `sum`.
/// The integral is `half` times this sum.
template <class F>
void add_gauss(double& sum, const F& f, double middle, double half) {
  constexpr double x[] = {0.1488743389816312, 0.4333953941292472, 0.6794095682990244,
                          0.8650633666889845, 0.9739065285171717};
  constexpr double w[] = {0.2955242247147529, 0.2692667193099963, 0.2190863625159820,
                          0.1494513491505806, 0.0666713443086881};
  for (std::size_t i = 0; i < 5; ++i) {
    const double off = x[i] * half;
    sum += w[i] * (f(middle - off) + f(middle + off));
  }
}

}  // namespace jounce
