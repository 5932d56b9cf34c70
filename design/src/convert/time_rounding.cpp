// SPDX-License-Identifier: Apache-2.0
#include "design/src/convert/time_rounding.hpp"

#include <algorithm>
#include <cmath>

#include "jounce/profiles/curve/extrema.hpp"
#include "jounce/profiles/detail/evaluate.hpp"

namespace jounce::design_detail {
namespace {

/// The changes of a quintic and of its derivatives if the value, the velocity and the acceleration at
/// one of its ends change by at most d: the greatest magnitudes of its Hermite polynomials.
Jet change_of(const Jet& d, double length) {
  const double h = length;
  const double p = std::abs(d[0]);
  const double v = std::abs(d[1]) * h;
  const double a = std::abs(d[2]) * h * h;
  return {p + 0.16 * v + 0.02 * a, (1.88 * p + v + 0.07 * a) / h, (5.78 * p + 4 * v + a) / (h * h),
          (60 * p + 36 * v + 9 * a) / (h * h * h)};
}

/// The value and the derivatives of a segment at the distance d from its start or its end.
Jet beyond(const Segment& f, bool end, double d) {
  return profiles_detail::evaluate(f, (end ? 1 : 0) + d / f.length);
}

/// The greatest magnitude of a derivative of a segment from s0 to s1.
double peak_of(const Segment& f, double s0, double s1, int order) {
  const Segment g = part(f, s0, s1);
  return std::abs(segment_range(g, 0, g.length, order).peak().value);
}

}  // namespace

std::size_t motion_of_knot(const Table& given, std::size_t i) {
  const auto& x = given.columns().x;
  if (i == 0) return 0;
  return i + 1 < x.size() && x[i + 1] - x[i] > x[i] - x[i - 1] ? i : i - 1;
}

std::vector<Jet> time_rounding(const Table& given, std::span<const double> moved) {
  std::vector<Jet> rises(given.columns().x.size() - 1);
  for (std::size_t i = 0; i < rises.size(); ++i) {
    const Segment own = given.segment(i);
    const double d0 = moved[i];
    const double d1 = moved[i + 1];
    const double length = own.length + d1 - d0;
    for (int order = 1; order <= 3; ++order)
      rises[i][static_cast<std::size_t>(order)] =
          std::max(0.0, peak_of(own, d0 / own.length, 1 + d1 / own.length, order) -
                            peak_of(own, 0, 1, order));
    for (const bool end : {false, true}) {
      const std::size_t knot = end ? i + 1 : i;
      const std::size_t from = motion_of_knot(given, knot);
      if (from == i) continue;
      const Jet mine = beyond(own, end, moved[knot]);
      const Jet other = beyond(given.segment(from), !end, moved[knot]);
      Jet d{};
      for (std::size_t k = 0; k < d.size(); ++k) d[k] = other[k] - mine[k];
      const Jet change = change_of(d, length);
      for (std::size_t k = 0; k < d.size(); ++k) rises[i][k] += change[k];
    }
  }
  return rises;
}

}  // namespace jounce::design_detail
