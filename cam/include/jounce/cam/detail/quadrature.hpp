// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "jounce/profiles/curve/segment.hpp"

namespace jounce::detail {

/// Calls visit(s, weight) so that the sum of weight * g(s) is the integral of g over s in [0, 1],
/// for a g that is a product of two of f's derivatives: Gauss-Legendre with ten points, exact for
/// polynomials to degree 19 (the square of a first derivative has at most 20: 1e-13 then). A sine
/// is cut into panels of at most 2 rad, where the remainder, (10!)^4 / (21 (20!)^3) of the 20th
/// derivative, is below 1e-16 of the terms: rounding.
template <class Visit>
void quadrature(const Segment& f, const Visit& visit) {
  constexpr std::array<double, 5> node{0.14887433898163122, 0.43339539412924719,
                                       0.67940956829902441, 0.86506336668898451,
                                       0.97390652851717172};
  constexpr std::array<double, 5> weight{0.29552422471475287, 0.26926671930999636,
                                         0.21908636251598204, 0.14945134915058059,
                                         0.06667134430868814};
  double widest = 0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(f.sines); ++i)
    widest = std::max(widest, std::abs(f.sine[i].angle));
  const double panels = std::max(1.0, std::ceil(widest / 2));
  for (double p = 0; p < panels; ++p)
    for (std::size_t k = 0; k < node.size(); ++k)
      for (const double x : {-node[k], node[k]})
        visit((p + 0.5 + x / 2) / panels, weight[k] / (2 * panels));
}

}  // namespace jounce::detail
