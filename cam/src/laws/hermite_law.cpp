// SPDX-License-Identifier: Apache-2.0
// The law `hermite` of a placed segment: its points, and the knots at its ends.
#include <algorithm>
#include <cmath>
#include <string>

#include "jounce/profiles/detail/tolerances.hpp"
#include "jounce/profiles/error.hpp"

#include "cam/src/design/resolve.hpp"
#include "cam/src/laws/hermite.hpp"

namespace jounce::cam_detail {
namespace {

using profiles_detail::rounded_input;

double required(const std::optional<double>& value, const std::string& key) {
  if (!value) throw InputError(key, "", "is missing: the law hermite needs it at every point");
  return *value;
}

HermitePoint hermite_point(const CamPoint& point, const std::string& key) {
  if (point.tolerance != 0)
    throw InputError(
        key + "tolerance", point.tolerance,
        "a hermite law passes through its points exactly: use `quintic_spline` for a tolerance");
  return {point.master, required(point.slave, key + "slave"),
          required(point.geo_velocity, key + "geo_velocity"),
          required(point.geo_acceleration, key + "geo_acceleration"), point.geo_jerk};
}

/// The point at the end of a segment: the derivatives of the knot if given, otherwise its own. Both
/// must agree, because a given value must not be ignored silently.
HermitePoint hermite_end(const Placed& at, const CamKnot& knot, const CamPoint* point,
                         const std::string& key) {
  HermitePoint end{knot.master,
                   knot.slave,
                   knot.geo_velocity.value_or(0),
                   knot.geo_acceleration.value_or(0),
                   {}};
  if (point == nullptr) return end;
  end.geo_jerk = point->geo_jerk;
  const double slope = std::abs(at.to.slave - at.from.slave) / at.length();
  const auto take = [&](const char* name, const std::optional<double>& own,
                        const std::optional<double>& of_knot, double& value, double scale) {
    if (!own) return;
    if (!of_knot) value = *own;
    scale = std::max({scale, std::abs(value), std::abs(*own)});
    if (std::abs(*own - value) > rounded_input * scale)
      throw InputError(key + name, *own, "must be " + number(value) + ", as at its knot");
  };
  take("slave", point->slave, knot.slave, end.slave, std::abs(at.to.slave - at.from.slave));
  take("geo_velocity", point->geo_velocity, knot.geo_velocity, end.geo_velocity, slope);
  take("geo_acceleration", point->geo_acceleration, knot.geo_acceleration, end.geo_acceleration,
       slope / at.length());
  return end;
}

}  // namespace

std::vector<Segment> through_hermite_points(const Placed& at) {
  const auto& points = at.spec->points;
  const auto key = [](std::size_t i) { return "points[" + std::to_string(i + 1) + "]."; };
  std::size_t first = 0;
  std::size_t last = points.size();
  const bool at_start = !points.empty() && points.front().master == at.from.master;
  const bool at_end = points.size() > first && points.back().master == at.to.master;
  if (at_start) ++first;
  if (at_end) --last;
  std::vector<HermitePoint> all{
      hermite_end(at, at.from, at_start ? &points.front() : nullptr, key(0))};
  for (std::size_t i = first; i < last; ++i) all.push_back(hermite_point(points[i], key(i)));
  all.push_back(hermite_end(at, at.to, at_end ? &points.back() : nullptr, key(last)));
  const bool jerks = std::any_of(all.begin(), all.end(), [](auto& p) { return p.geo_jerk; });
  for (const HermitePoint& point : all)
    if (jerks && !point.geo_jerk)
      throw InputError("points", static_cast<double>(points.size()),
                       "must all have a geo_jerk or none, points at both ends of the segment "
                       "included: at " +
                           number(point.master) + " there is none");
  return hermite(all);
}

}  // namespace jounce::cam_detail
