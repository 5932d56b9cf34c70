// SPDX-License-Identifier: Apache-2.0
#include "pvt/src/sample/interval.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "jounce/profiles/curve/roots.hpp"
#include "jounce/profiles/detail/bernstein.hpp"
#include "jounce/profiles/detail/tolerances.hpp"

// The difference between the polynomial of the table and the segments of the curve. Each piece is
// decided by the cheapest possible test:
//
//   (1)  A value of the difference anywhere is at most its maximum: a few values in the interval
//        reveal most intervals that are too long.
//   (2)  A segment is at most the sum of the magnitudes of its terms; a polynomial is within the
//        range of its Bernstein coefficients. A piece for which either is within the greatest error
//        found so far adds nothing.
//   (3)  Otherwise the error of the piece is the greatest of its values at its ends and at the
//        zeros of its derivative.
namespace jounce::pvt_detail {
namespace {

using profiles_detail::one_rounding;

/// True if (2) is within the bound.
bool hull_within(const Segment& d, double bound) {
  if (d.sines > 0) return false;
  bool within = false;
  profiles_detail::with_degree(static_cast<std::size_t>(d.degree), [&](auto n) {
    const auto [lo, hi] = profiles_detail::hull<n>(profiles_detail::to_bernstein<n>(d));
    within = std::max(-lo, hi) <= bound;
  });
  return within;
}

/// The exact peak, by (3).
double exact_peak(const Segment& d) {
  double peak = std::max(std::abs(value(d, 0)), std::abs(value(d, 1)));
  thread_local std::vector<double> critical;
  roots(derivative(d), one_rounding * magnitude(d) / d.length, critical);
  for (const double s : critical) peak = std::max(peak, std::abs(value(d, s)));
  return peak;
}

/// The greater of `worst` and the share of its tolerance that the difference d uses.
double raised(double worst, const Segment& d, double tolerance) {
  const double bound = worst * tolerance;
  if (magnitude(d) <= bound || hull_within(d, bound)) return worst;
  return std::max(worst, exact_peak(d) / tolerance);
}

/// Computes (1).
template <class Over>
double sampled(const Curve<Over>& f, const Segment& table, double start,
               const Tolerances& allowed) {
  double worst = 0;
  for (const double s : {0.5, 0.25, 0.75, 0.1, 0.9, 0.35, 0.65}) {
    const Jet here = evaluate(table, s);
    const Jet wanted = f.jet(start + s * table.length);
    worst = std::max({worst, std::abs(here[0] - wanted[0]) / allowed.position,
                      std::abs(here[1] - wanted[1]) / allowed.velocity});
    if (worst > 1) break;
  }
  return worst;
}

/// part() of a segment; the segment itself if the part is the whole.
Segment cut(const Segment& f, double s0, double s1) {
  return s0 == 0 && s1 == 1 ? f : part(f, s0, s1);
}

}  // namespace

Segment between(Interpolation rule, const Knot& a, const Knot& b) {
  const double length = b.x - a.x;
  switch (rule) {
    case Interpolation::linear:
      return line(length, a.jet[0], b.jet[0]);
    case Interpolation::cubic_hermite:
      return cubic(length, a.jet[0], a.jet[1], b.jet[0], b.jet[1]);
    case Interpolation::quintic_hermite:
      break;
  }
  return quintic(length, a.jet[0], a.jet[1], a.jet[2], b.jet[0], b.jet[1], b.jet[2]);
}

template <class Over>
double share(const Curve<Over>& f, Interpolation rule, const Knot& a, const Knot& b,
             const Tolerances& tolerances) {
  const Segment table = between(rule, a, b);
  double worst = sampled(f, table, a.x, tolerances);
  const auto breaks = f.breaks();
  const auto above = std::upper_bound(breaks.begin() + 1, breaks.end() - 1, a.x);
  auto k = static_cast<std::size_t>(above - breaks.begin()) - 1;
  for (double x = a.x; worst <= 1 && x < b.x && k < f.segments().size(); ++k) {
    const Segment& segment = f.segments()[k];
    const double end = std::min(b.x, breaks[k + 1]);
    const double s0 = std::clamp((x - breaks[k]) / segment.length, 0.0, 1.0);
    const double s1 =
        end == breaks[k + 1] ? 1 : std::clamp((end - breaks[k]) / segment.length, 0.0, 1.0);
    const double t0 = (x - a.x) / table.length;
    const double t1 = end == b.x ? 1 : std::min(1.0, (end - a.x) / table.length);
    x = end;
    if (!(s0 < s1 && t0 < t1)) continue;  // shorter than the rounding of positions
    Segment there = cut(segment, s0, s1);
    const Segment here = cut(table, t0, t1);
    there.length = here.length;
    const auto d = sum(here, scaled(there, -1));  // fits: a polynomial adds no sine
    worst = raised(worst, *d, tolerances.position);
    if (std::isfinite(tolerances.velocity))
      worst = raised(worst, derivative(*d), tolerances.velocity);
  }
  return worst;
}

template double share(const Curve<OverTime>&, Interpolation, const Knot&, const Knot&,
                      const Tolerances&);
template double share(const Curve<OverMaster>&, Interpolation, const Knot&, const Knot&,
                      const Tolerances&);

}  // namespace jounce::pvt_detail
