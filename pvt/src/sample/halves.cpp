// SPDX-License-Identifier: Apache-2.0
#include "pvt/src/sample/halves.hpp"

#include <algorithm>
#include <cmath>

#include "jounce/profiles/detail/numeric.hpp"
#include "jounce/profiles/detail/tolerances.hpp"

#include "pvt/src/sample/whole_steps.hpp"

namespace jounce::pvt_detail {

bool is_one_quadratic(const Knot& a, const Knot& b) {
  const double h = b.x - a.x;
  const double mean = (a.jet[1] + b.jet[1]) / 2;
  const double size =
      std::abs(a.jet[0]) + std::abs(b.jet[0]) + (std::abs(a.jet[1]) + std::abs(b.jet[1])) * h;
  return std::abs(b.jet[0] - a.jet[0] - mean * h) <= profiles_detail::rounded_root * size;
}

std::optional<Knot> knot_between(const Target& target, const Knot& a, const Knot& b) {
  const double x = rounded_to(a.x + (b.x - a.x) / 2, target.x_step);
  const double least = target.spacing * (1 - profiles_detail::rounded_sum);
  const double h_a = x - a.x;
  const double h_b = b.x - x;
  if (!(h_a > 0 && h_b > 0 && h_a >= least && h_b >= least)) return std::nullopt;
  const double P = b.jet[0] - a.jet[0];
  const double v = (2 * P - a.jet[1] * h_a - b.jet[1] * h_b) / (h_a + h_b);  // (1)
  return Knot{x, Side::right, {a.jet[0] + (a.jet[1] + v) * h_a / 2, v, 0, 0}};
}

template <class Over>
double share(const Curve<Over>& f, const Target& target, const Knot& a, const Knot& b,
             const Tolerances& tolerances) {
  if (!target.quadratic || is_one_quadratic(a, b)) return share(f, target.rule, a, b, tolerances);
  const auto between = knot_between(target, a, b);
  if (!between) return profiles_detail::inf;
  const double first = share(f, target.rule, a, *between, tolerances);
  return first > 1 ? first : std::max(first, share(f, target.rule, *between, b, tolerances));
}

template double share(const Curve<OverTime>&, const Target&, const Knot&, const Knot&,
                      const Tolerances&);
template double share(const Curve<OverMaster>&, const Target&, const Knot&, const Knot&,
                      const Tolerances&);

}  // namespace jounce::pvt_detail
