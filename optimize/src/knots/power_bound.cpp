// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "optimize/src/knots/bound.hpp"

// The energy E = f'^2 / 2 has the power f' f'' = E'. With |E'| <= P and x measured from the start,
//
//   (1)  |f'| <= sqrt(v0^2 + 2 P x)   and   |f'| <= sqrt(v1^2 + 2 P (L - x))
//
// and the displacement is at most the integral of the lower of the two, which meet at
//
//   (2)  x = L / 2 + (v1^2 - v0^2) / (4 P)
//
//   (3)  integral of sqrt(v^2 + 2 P x) over 0 ... a = ((v^2 + 2 P a)^(3/2) - |v|^3) / (3 P)
//
// From rest to rest the displacement is h = 2/3 sqrt(P) L^(3/2), and therefore P = 9/4 h^2 / L^3.
// In general the displacement grows with P, and P is found by bisection.

namespace jounce {
namespace {

double way(double v, double power, double a) {  // (3)
  const double square = v * v + 2 * power * a;
  return (square * std::sqrt(square) - std::abs(v * v * v)) / (3 * power);
}

double longest_way(const KnotInterval& s, double power) {
  const double meet =
      std::clamp(s.length / 2 + (s.v1 * s.v1 - s.v0 * s.v0) / (4 * power), 0.0, s.length);
  return way(s.v0, power, meet) + way(s.v1, power, s.length - meet);
}

}  // namespace

double least_peak_power(const KnotInterval& s) {
  const double least = std::abs(s.v1 * s.v1 - s.v0 * s.v0) / (2 * s.length);  // to change E at all
  const double wanted = std::abs(s.displacement);
  double high = std::max(least, 9.0 / 4 * wanted * wanted / std::pow(s.length, 3));
  double low = least;
  if (high == 0 || (low > 0 && longest_way(s, low) >= wanted)) return low;
  for (int k = 0; k < 200; ++k) {
    const double middle = (low + high) / 2;
    if (middle <= low || middle >= high) break;
    (longest_way(s, middle) >= wanted ? high : low) = middle;
  }
  return low;
}

}  // namespace jounce
