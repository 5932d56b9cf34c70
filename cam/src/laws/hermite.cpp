// SPDX-License-Identifier: Apache-2.0
#include "cam/src/laws/hermite.hpp"

#include <string>
#include <utility>

#include "jounce/profiles/error.hpp"

// Over s = u / L, with the derivatives with respect to s at both ends (v L, a L^2, j L^3), c0 to c3
// follow from the left end. Let d_k be the remainder of the k-th derivative at the right end: sum
// over i > 3 of i!/(i-k)! c_i = d_k, k = 0..3. The inverse is:
//
//     (1)  c4 =  35 d0 - 15 d1 + 5/2 d2 - 1/6 d3
//          c5 = -84 d0 + 39 d1 -   7 d2 + 1/2 d3
//          c6 =  70 d0 - 34 d1 + 13/2 d2 - 1/2 d3
//          c7 = -20 d0 + 10 d1 -   2 d2 + 1/6 d3

namespace jounce {
namespace {

Segment seventh_degree(double length, const HermitePoint& from, const HermitePoint& to) {
  const double l2 = length * length;
  const double l3 = l2 * length;
  Segment f;
  f.length = length;
  f.degree = 7;
  f.c[0] = from.slave;
  f.c[1] = from.geo_velocity * length;
  f.c[2] = from.geo_acceleration * l2 / 2;
  f.c[3] = *from.geo_jerk * l3 / 6;
  const double d0 = (to.slave - f.c[0]) - (f.c[1] + f.c[2] + f.c[3]);
  const double d1 = to.geo_velocity * length - (f.c[1] + 2 * f.c[2] + 3 * f.c[3]);
  const double d2 = to.geo_acceleration * l2 - (2 * f.c[2] + 6 * f.c[3]);
  const double d3 = *to.geo_jerk * l3 - 6 * f.c[3];
  f.c[4] = 35 * d0 - 15 * d1 + 2.5 * d2 - d3 / 6;  // (1)
  f.c[5] = -84 * d0 + 39 * d1 - 7 * d2 + d3 / 2;
  f.c[6] = 70 * d0 - 34 * d1 + 6.5 * d2 - d3 / 2;
  f.c[7] = -20 * d0 + 10 * d1 - 2 * d2 + d3 / 6;
  return f;
}

void require_point(const HermitePoint& p, const std::string& key) {
  for (const auto& [name, value] : {std::pair{"master", p.master},
                                    {"slave", p.slave},
                                    {"geo_velocity", p.geo_velocity},
                                    {"geo_acceleration", p.geo_acceleration},
                                    {"geo_jerk", p.geo_jerk.value_or(0)}})
    require_finite((key + name).c_str(), value);
}

void require_valid(std::span<const HermitePoint> points) {
  if (points.size() < 2)
    throw InputError("points", std::to_string(points.size()), "must be at least 2");
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::string key = "points[" + std::to_string(i + 1) + "].";
    require_point(points[i], key);
    if (i == 0) continue;
    if (!(points[i].master > points[i - 1].master))
      throw InputError(
          key + "master", points[i].master,
          "must be greater than " + number(points[i - 1].master) + ", the previous point");
    if (points[i].geo_jerk.has_value() != points[0].geo_jerk.has_value())
      throw InputError(key + "geo_jerk", "", "must be given at all points or at none");
  }
}

}  // namespace

std::vector<Segment> hermite(std::span<const HermitePoint> points) {
  require_valid(points);
  std::vector<Segment> pieces;
  pieces.reserve(points.size() - 1);
  for (std::size_t i = 1; i < points.size(); ++i) {
    const HermitePoint& a = points[i - 1];
    const HermitePoint& b = points[i];
    const double length = b.master - a.master;
    pieces.push_back(a.geo_jerk ? seventh_degree(length, a, b)
                                : quintic(length, a.slave, a.geo_velocity, a.geo_acceleration,
                                          b.slave, b.geo_velocity, b.geo_acceleration));
  }
  return pieces;
}

}  // namespace jounce
