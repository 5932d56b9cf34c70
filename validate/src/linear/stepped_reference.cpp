// SPDX-License-Identifier: Apache-2.0 The quintic between two setpoints p_0, v_0, a_0 and p_1, v_1,
// a_1, T apart. With d = p_1 - p_0 - v_0 T - a_0 T^2 / 2, e = v_1 - v_0 - a_0 T and f = a_1 - a_0
//
//     (1)  r(t) = p_0 + v_0 t + a_0 t^2 / 2 + c_3 t^3 + c_4 t^4 + c_5 t^5
//     (2)  c_3 T^3 = 10 d - 4 e T + f T^2 / 2
//     (3)  c_4 T^4 = -15 d + 7 e T - f T^2
//     (4)  c_5 T^5 = 6 d - 3 e T + f T^2 / 2
//
// How a corner is detected. For a smooth motion the error of the trapezoidal rule with end
// correction (Euler, Maclaurin) is
//
//     (5)  p_1 - p_0 - (v_0 + v_1) T / 2 + (a_1 - a_0) T^2 / 12 = O(T^5)
//
// At a step of the acceleration it is at most 1/12 of |v_1 - v_0| T; at a corner it is 1/2 of
// |v_1 - v_0| T. The limit between them is 0.2.

#include "validate/src/linear/stepped_reference.hpp"

#include <cmath>
#include <cstddef>

namespace jounce::validate_detail {

SteppedReference::SteppedReference(const Jet& from, const Jet& to, double T) {
  const double way = to[0] - from[0];
  const double f = to[2] - from[2];
  const double mismatch = way - (from[1] + to[1]) * T / 2 + f * T * T / 12;  // (5)
  if (std::abs(mismatch) > 0.2 * T * std::abs(to[1] - from[1])) {
    c_[1] = way / T;
    return;
  }
  const double d = way - from[1] * T - from[2] * T * T / 2;
  const double e = to[1] - from[1] - from[2] * T;
  c_ = {0,
        from[1],
        from[2] / 2,
        (10 * d - 4 * e * T + f * T * T / 2) / (T * T * T),          // (2)
        (-15 * d + 7 * e * T - f * T * T) / (T * T * T * T),         // (3)
        (6 * d - 3 * e * T + f * T * T / 2) / (T * T * T * T * T)};  // (4)
}

std::array<double, SteppedReference::derivatives> SteppedReference::rates(double t) const {
  std::array<double, derivatives + 1> c = c_;
  std::array<double, derivatives> rates{};
  double factor = 1;
  for (std::size_t k = 0; k <= derivatives; ++k) {  // Horner's rule repeated
    for (std::size_t i = derivatives; i-- > k;) c[i] += t * c[i + 1];
    if (k > 0) rates[k - 1] = factor * c[k];
    factor *= static_cast<double>(k + 1);
  }
  return rates;
}

Jet SteppedReference::at(double t) const {
  double way = 0;
  for (std::size_t k = derivatives + 1; k-- > 0;) way = way * t + c_[k];
  const auto r = rates(t);
  return {way, r[0], r[1], r[2]};
}

}  // namespace jounce::validate_detail
