// SPDX-License-Identifier: Apache-2.0
#include "pvt/src/sample/corridor.hpp"

#include <algorithm>

// The velocities (v0, v1) that a piece permits are a convex polygon: the rectangle of both gaps,
// cut by half planes one after another (Sutherland and Hodgman 1974). Its projection on an axis is
// the set of those velocities for which the other velocity exists. Because each set is the exact
// projection, a way through the last gap leads back through all gaps (dynamic programming; nothing
// is tried twice).

namespace jounce::pvt_detail {
namespace {

struct PolygonCorner {
  double v0 = 0;
  double v1 = 0;
};

/// A cut by a half plane adds at most one corner.
struct Polygon {
  std::array<PolygonCorner, 4 + Demand::most + 1> corners;
  std::size_t size = 0;

  void add(PolygonCorner corner) { corners[size++] = corner; }
};

double excess(const HalfPlane& plane, const PolygonCorner& corner) {
  return plane.a * corner.v0 + plane.b * corner.v1 - plane.c;
}

bool keeps(const Polygon& polygon, const HalfPlane& plane) {
  return std::all_of(polygon.corners.begin(), polygon.corners.begin() + polygon.size,
                     [&](const PolygonCorner& corner) { return excess(plane, corner) <= 0; });
}

Polygon cut(const Polygon& polygon, const HalfPlane& plane) {
  Polygon left;
  for (std::size_t i = 0; i < polygon.size; ++i) {
    const PolygonCorner& from = polygon.corners[i];
    const PolygonCorner& to = polygon.corners[i + 1 < polygon.size ? i + 1 : 0];
    const double before = excess(plane, from), after = excess(plane, to);
    if (before <= 0) left.add(from);
    if ((before < 0 && after > 0) || (before > 0 && after < 0)) {
      const double s = before / (before - after);
      left.add({from.v0 + s * (to.v0 - from.v0), from.v1 + s * (to.v1 - from.v1)});
    }
  }
  return left;
}

Polygon permitted(const Demand& demand, Gap v0, Gap v1) {
  Polygon polygon;
  for (const PolygonCorner corner :
       {PolygonCorner{v0.lo, v1.lo}, {v0.hi, v1.lo}, {v0.hi, v1.hi}, {v0.lo, v1.hi}})
    polygon.add(corner);
  for (const HalfPlane& plane : demand.planes())
    if (!keeps(polygon, plane)) polygon = cut(polygon, plane);
  return polygon;
}

std::optional<Gap> shadow(const Polygon& polygon, Gap within) {
  if (polygon.size == 0) return std::nullopt;
  Gap gap{within.hi, within.lo};
  for (std::size_t i = 0; i < polygon.size; ++i) {
    gap.lo = std::min(gap.lo, polygon.corners[i].v1);
    gap.hi = std::max(gap.hi, polygon.corners[i].v1);
  }
  return Gap{std::max(gap.lo, within.lo), std::min(gap.hi, within.hi)};
}

}  // namespace

std::optional<Gap> reached(const Demand& demand, Gap from, Gap to) {
  return shadow(permitted(demand, from, to), to);
}

Gap leading_to(const Demand& demand, Gap from, double v1) {
  Gap gap = from;
  for (const HalfPlane& plane : demand.planes()) {
    const double room = plane.c - plane.b * v1;
    if (plane.a > 0) gap.hi = std::min(gap.hi, room / plane.a);
    if (plane.a < 0) gap.lo = std::max(gap.lo, room / plane.a);
  }
  if (gap.lo <= gap.hi) return gap;
  const double middle = std::clamp(gap.hi + (gap.lo - gap.hi) / 2, from.lo, from.hi);
  return {middle, middle};
}

}  // namespace jounce::pvt_detail
