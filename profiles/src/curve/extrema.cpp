// SPDX-License-Identifier: Apache-2.0
#include "jounce/profiles/curve/extrema.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "jounce/profiles/curve/over_length.hpp"
#include "jounce/profiles/curve/roots.hpp"
#include "jounce/profiles/detail/bernstein.hpp"
#include "jounce/profiles/detail/derivative_order.hpp"
#include "jounce/profiles/detail/tolerances.hpp"

namespace jounce {
namespace {

using profiles_detail::one_rounding;
/// Extends the range by a candidate. `noise`: the least improvement, so that rounding does not move
/// the position.
void widen(Range& range, const Extremum& candidate, double noise = 0) {
  if (candidate.value < range.min.value - noise) range.min = candidate;
  if (candidate.value > range.max.value + noise) range.max = candidate;
}

/// SegmentHulls of the value and its derivatives on a segment, wider than their rounding.
using SegmentHulls = std::array<std::pair<double, double>, 4>;

/// Adds the bounds of the sine terms: their amplitudes.
void add_sines(const Segment& f, SegmentHulls& bounds) {
  for (std::size_t i = 0; i < static_cast<std::size_t>(f.sines); ++i) {
    double most = std::abs(f.sine[i].amplitude);
    for (auto& [low, high] : bounds) {
      low -= most;
      high += most;
      most *= std::abs(f.sine[i].angle) / f.length;
    }
  }
}

/// The hulls of the Bernstein coefficients of a polynomial, and of their differences. Each
/// difference doubles the rounding. The constant term is added last: it would only add rounding.
template <std::size_t n>
SegmentHulls hulls(const Segment& f) {
  auto c = f.c;
  c[0] = 0;
  auto beta = profiles_detail::to_bernstein<n>(c);
  double scale = 0;
  for (std::size_t k = 1; k <= n; ++k) scale += std::abs(c[k]);
  SegmentHulls bounds{};
  const std::size_t orders = std::min(bounds.size(), n + 1);
  for (std::size_t k = 0; k < orders; ++k) {
    double low = beta[0];
    double high = beta[0];
    for (std::size_t i = 1; i + k <= n; ++i) {
      low = std::min(low, beta[i]);
      high = std::max(high, beta[i]);
    }
    const double noise = profiles_detail::rounded_value * scale;
    bounds[k] = {low - noise, high + noise};
    const double rate = static_cast<double>(n - k) / f.length;
    for (std::size_t i = 0; i + k < n; ++i) beta[i] = (beta[i + 1] - beta[i]) * rate;
    scale *= 2 * rate;
  }
  const double noise = profiles_detail::rounded_value * std::abs(f.c[0]);
  bounds[0].first += f.c[0] - noise;
  bounds[0].second += f.c[0] + noise;
  return bounds;
}

SegmentHulls bounds_of(const Segment& f) {
  SegmentHulls bounds{};
  profiles_detail::with_degree(static_cast<std::size_t>(f.degree),
                               [&](auto n) { bounds = hulls<n>(f); });
  add_sines(f, bounds);
  return bounds;
}

/// True if f has the same sign everywhere, except for less than `flat` on average. The integral
/// over s of a Bernstein polynomial of degree n is at most the sum of its coefficients of that
/// sign, divided by n + 1.
bool keeps_sign(const Segment& f, double flat) {
  if (f.sines > 0) return false;
  bool keeps = false;
  profiles_detail::with_degree(static_cast<std::size_t>(f.degree), [&](auto n) {
    double above = 0;
    double below = 0;
    for (const double beta : profiles_detail::to_bernstein<n>(f))
      (beta > 0 ? above : below) += beta;
    keeps = std::min(above, -below) <= flat * static_cast<double>(n + 1);
  });
  return keeps;
}

/// Range of g on the segment that begins at `start`; dg is its derivative with respect to u.
Range range_on(const Segment& g, const Segment& dg, double start, double end) {
  const Extremum first{value(g, 0), start, Side::right};
  Range range{first, first};
  const double noise = one_rounding * magnitude(g);
  // If |g'| stays below this, g changes by less than its own rounding over the whole segment. If
  // g' passes zero by no more than this, no value within lies beyond both ends.
  const double flat = noise / g.length;
  if (flat > 0 && !keeps_sign(dg, flat)) {
    thread_local std::vector<double> critical;
    roots(dg, flat, critical);
    for (const double s : critical)
      widen(range, {value(g, s), start + s * g.length, Side::right}, noise);
  }
  widen(range, {value(g, 1), end, Side::left});
  return range;
}

}  // namespace

const Extremum& Range::peak() const {
  return std::abs(min.value) > std::abs(max.value) ? min : max;
}

void widen(Ranges& ranges, const Ranges& after) {
  for (std::size_t k = 0; k < ranges.size(); ++k) {
    widen(ranges[k], after[k].min);
    widen(ranges[k], after[k].max);
  }
}

void widen(Ranges& ranges, const Segment& f, double start, double end) {
  const SegmentHulls bounds = bounds_of(f);
  for (std::size_t k = 0; k < ranges.size(); ++k) {
    const auto& [low, high] = bounds[k];
    if (low >= ranges[k].min.value && high <= ranges[k].max.value) continue;
    const Range here = segment_range(f, start, end, static_cast<int>(k));
    widen(ranges[k], here.min);
    widen(ranges[k], here.max);
  }
}

Range segment_range(const Segment& f, double start, double end, int order) {
  profiles_detail::require_order(order);
  Segment g = f;
  for (int k = 0; k < order; ++k) g = derivative(g);
  return range_on(g, derivative(g), start, end);
}

template <class Over>
Range segment_range(const Curve<Over>& f, std::size_t segment, int order) {
  return segment_range(f.segments()[segment], f.breaks()[segment], f.breaks()[segment + 1], order);
}

Ranges segment_extrema(const Segment& f, double start, double end) {
  Ranges ranges;
  Segment g = f;
  for (auto& range : ranges) {
    const Segment dg = derivative(g);
    range = range_on(g, dg, start, end);
    g = dg;
  }
  return ranges;
}

template <class Over>
Ranges segment_extrema(const Curve<Over>& f, std::size_t segment) {
  return segment_extrema(f.segments()[segment], f.breaks()[segment], f.breaks()[segment + 1]);
}

template <class Over>
Ranges segment_extrema(const Curve<Over>& f, std::size_t first, std::size_t last) {
  Ranges all = segment_extrema(f, first);
  for (std::size_t i = first + 1; i <= last; ++i)
    widen(all, f.segments()[i], f.breaks()[i], f.breaks()[i + 1]);
  return all;
}

template <class Over>
Ranges extrema(const Curve<Over>& f) {
  return segment_extrema(f, 0, f.segments().size() - 1);
}

template <class Over>
Range extrema(const Curve<Over>& f, int order) {
  Range all = segment_range(f, 0, order);
  for (std::size_t i = 1; i < f.segments().size(); ++i) {
    const Range here = segment_range(f, i, order);
    widen(all, here.min);
    widen(all, here.max);
  }
  return all;
}

template <class Over>
Jump largest_jump(const Curve<Over>& f, int order) {
  profiles_detail::require_order(order);
  const auto k = static_cast<std::size_t>(order);
  const auto pieces = f.segments();
  Jump largest;
  const auto consider = [&](const Segment& before, const Segment& after, double where) {
    const double step = evaluate(after, 0)[k] - evaluate(before, 1)[k];
    if (std::abs(step) > std::abs(largest.step)) largest = {step, where};
  };
  for (std::size_t i = 1; i < pieces.size(); ++i) consider(pieces[i - 1], pieces[i], f.breaks()[i]);
  if (f.outside() == Extrapolation::wrap || (f.outside() == Extrapolation::advance && order > 0))
    consider(pieces.back(), pieces.front(), f.end());
  if (f.outside() == Extrapolation::hold && order > 0) {  // at rest before and after the interval
    const double first = evaluate(pieces.front(), 0)[k];
    const double last = -evaluate(pieces.back(), 1)[k];
    if (std::abs(first) > std::abs(largest.step)) largest = {first, f.start()};
    if (std::abs(last) > std::abs(largest.step)) largest = {last, f.end()};
  }
  return largest;
}

#define JOUNCE_INSTANTIATE(Over)                                                 \
  template Range segment_range(const Curve<Over>&, std::size_t, int);            \
  template Ranges segment_extrema(const Curve<Over>&, std::size_t);              \
  template Ranges segment_extrema(const Curve<Over>&, std::size_t, std::size_t); \
  template Ranges extrema(const Curve<Over>&);                                   \
  template Range extrema(const Curve<Over>&, int);                               \
  template Jump largest_jump(const Curve<Over>&, int);
JOUNCE_INSTANTIATE(OverTime)
JOUNCE_INSTANTIATE(OverMaster)
JOUNCE_INSTANTIATE(OverLength)
#undef JOUNCE_INSTANTIATE

}  // namespace jounce
