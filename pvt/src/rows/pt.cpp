// SPDX-License-Identifier: Apache-2.0
#include "jounce/pvt/pt.hpp"

#include <cmath>
#include <string>
#include <type_traits>
#include <utility>

#include "jounce/profiles/error.hpp"

#include "pvt/src/rows/pt_link.hpp"

// A rate that changes linearly from a to b covers, with u the distance from the segment's start and
// s = u / T,
//
//     f(u) = f0 + a u + (b - a) u^2 / (2 T) = f0 + (a T) s + (b - a) T/2 s^2      (1)
//     P    = f(T) - f0 = (a + b) T / 2,   so   b = 2 P / T - a                    (2)
//
// With (2), the last coefficient of (1) is (b - a) T / 2 = P - a T. So there is no quotient that
// would be multiplied back, and f(T) = f0 + P to the rounding of the sum.

namespace jounce {
namespace {

using Link = pvt_detail::PtLink;

template <class Over>
std::string key(std::size_t i, bool of_x) {
  const char* x = std::is_same_v<Over, OverTime> ? "time" : "master";
  return "point[" + std::to_string(i + 1) + "]." + (of_x ? x : "position");
}

template <class Over>
void require_valid(std::span<const PtPoint> points, double start_rate) {
  if (points.empty())
    throw InputError("point", "", "is missing: a PT table needs at least one point");
  require_finite("start_rate", start_rate);
  double before = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto& [x, position, type] = points[i];
    if (!std::isfinite(x)) throw InputError(key<Over>(i, true), x, "must be a finite number");
    if (!std::isfinite(position))
      throw InputError(key<Over>(i, false), position, "must be a finite number");
    if (!(x > before))
      throw InputError(key<Over>(i, true), x,
                       "must be greater than " + number(before) +
                           (i > 0 ? ", the previous point" : ", the start of the table"));
    before = x;
  }
}

PtRate rate_of(PtType type, double mean, bool first, double before) {
  switch (type) {
    case PtType::even:
      return {mean, mean};
    case PtType::stop:
      return {2 * mean, 0};
    case PtType::normal:
      if (first) return {0, 2 * mean};
      break;
    case PtType::continued:
      break;
  }
  return {before, 2 * mean - before};
}

/// Calls `use` for each segment.
template <class Over, class Use>
void for_each_link(std::span<const PtPoint> points, double start_rate, Use&& use) {
  require_valid<Over>(points, start_rate);
  PtPoint before;
  double rate = start_rate;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Link link = pvt_detail::pt_link(before, points[i], i == 0, rate);
    if (!std::isfinite(link.rate.end) || !std::isfinite(2 * link.distance))
      throw InputError(key<Over>(i, false), points[i].position,
                       "is too far from " + number(before.position) +
                           ", the previous point: the velocity exceeds the range of a double");
    use(link);
    rate = link.rate.end;
    before = points[i];
  }
}

}  // namespace

namespace pvt_detail {

PtLink pt_link(const PtPoint& before, const PtPoint& point, bool first, double rate) {
  const double length = point.x - before.x;
  const double distance = point.position - before.position;
  return {before.position, length, distance, point.type,
          rate_of(point.type, distance / length, first, rate)};
}

/// (1)
Segment segment_of(const PtLink& link) {
  Segment f;
  f.length = link.length;
  f.c = {link.from, link.distance};
  if (link.type == PtType::stop) f.c[1] = 2 * link.distance;
  if (link.type == PtType::normal || link.type == PtType::continued)
    f.c[1] = link.rate.start * link.length;
  f.c[2] = link.distance - f.c[1];
  f.degree = f.c[2] != 0 ? 2 : 1;
  return f;
}

}  // namespace pvt_detail

template <class Over>
std::vector<PtRate> pt_rates(std::span<const PtPoint> points, double start_rate) {
  std::vector<PtRate> rates;
  rates.reserve(points.size());
  for_each_link<Over>(points, start_rate, [&](const Link& link) { rates.push_back(link.rate); });
  return rates;
}

template <class Over>
Curve<Over> pt(std::span<const PtPoint> points, double start_rate, Extrapolation outside) {
  return pt_loops<Over>(points, 1, start_rate, outside);
}

template <class Over>
Curve<Over> pt_loops(std::span<const PtPoint> points, int loops, double start_rate,
                     Extrapolation outside) {
  if (loops < 1) throw InputError("loops", std::to_string(loops), "must be at least 1");
  std::vector<Segment> segments;
  segments.reserve(points.size() * static_cast<std::size_t>(loops));
  double rate = start_rate;
  for (int pass = 0; pass < loops; ++pass) {
    const double begin = pass * (points.empty() ? 0 : points.back().position);
    double end = rate;
    for_each_link<Over>(points, rate, [&](const Link& link) {
      segments.push_back(scaled(pvt_detail::segment_of(link), 1, begin));
      end = link.rate.end;
    });
    rate = end;
  }
  return Curve<Over>(std::move(segments), 0, outside);
}

#define JOUNCE_INSTANTIATE(Over)                                                  \
  template std::vector<PtRate> pt_rates<Over>(std::span<const PtPoint>, double);  \
  template Curve<Over> pt<Over>(std::span<const PtPoint>, double, Extrapolation); \
  template Curve<Over> pt_loops<Over>(std::span<const PtPoint>, int, double, Extrapolation);
JOUNCE_INSTANTIATE(OverTime)
JOUNCE_INSTANTIATE(OverMaster)
#undef JOUNCE_INSTANTIATE

}  // namespace jounce
