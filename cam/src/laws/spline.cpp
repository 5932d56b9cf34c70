// SPDX-License-Identifier: Apache-2.0
#include "jounce/cam/laws/spline.hpp"

#include <string>

#include "jounce/cam/laws/b_spline.hpp"
#include "jounce/profiles/error.hpp"

#include "cam/src/design/least_energy.hpp"
#include "cam/src/design/table.hpp"

// The cubic spline has the least integral of the square of the second derivative of all functions
// through the points, the quintic spline that of the third (Schoenberg 1964; de Boor, ch. V).
// least_energy.cpp computes them as such. An omitted derivative at an end makes the boundary
// terms of the partial integration vanish there: the natural end. With not-a-knot ends the number
// of knots equals that of the conditions, and the spline is a B-spline through the points
// (b_spline.cpp).

namespace jounce {
namespace {

std::string point_key(std::size_t i, const char* field) {
  return "points[" + std::to_string(i + 1) + "]." + field;
}

void require_end(const char* which, const SplineEnd& end, bool takes_any) {
  const auto require = [&](const char* field, const std::optional<double>& value) {
    if (!value) return;
    const std::string key = std::string(which) + "." + field;
    require_finite(key.c_str(), *value);
    if (!takes_any)
      throw InputError(key, *value, "only natural ends take a derivative: leave it out");
  };
  require("geo_velocity", end.geo_velocity);
  require("geo_acceleration", end.geo_acceleration);
}

void refuse_acceleration(const char* which, const SplineEnd& end) {
  if (end.geo_acceleration)
    throw InputError(std::string(which) + ".geo_acceleration", *end.geo_acceleration,
                     "a cubic spline takes geo_velocity only: use a quintic spline");
}

std::vector<cam_detail::EnergyKnot> knots_of(const SplineSpec& spec) {
  std::vector<cam_detail::EnergyKnot> knots;
  for (const SplinePoint& p : spec.points)
    knots.push_back({p.master, {p.slave, 0, 0}, {true, false, false}});
  cam_detail::give(knots.front(), spec.start);
  cam_detail::give(knots.back(), spec.end);
  return knots;
}

std::vector<Segment> least(const SplineSpec& spec, cam_detail::Energy energy) {
  auto knots = knots_of(spec);
  cam_detail::minimize(knots, energy, spec.ends == SplineEnds::periodic);
  return cam_detail::segments_between(knots, energy);
}

std::vector<Segment> not_a_knot(const SplineSpec& spec, int degree) {
  const int most = static_cast<int>(spec.points.size()) - 1;
  return b_spline(interpolating_b_spline(spec.points, degree < most ? degree : most));
}

}  // namespace

void cam_detail::require_points(const std::vector<SplinePoint>& points, std::size_t least,
                                bool tolerances) {
  if (points.size() < least)
    throw InputError("points", std::to_string(points.size()),
                     "must be at least " + std::to_string(least));
  for (std::size_t i = 0; i < points.size(); ++i) {
    const SplinePoint& p = points[i];
    require_finite(point_key(i, "master").c_str(), p.master);
    require_finite(point_key(i, "slave").c_str(), p.slave);
    require_not_negative(point_key(i, "tolerance").c_str(), p.tolerance);
    if (!tolerances && p.tolerance != 0)
      throw InputError(point_key(i, "tolerance"), p.tolerance,
                       "a spline through points has none: use a smoothing spline");
    if (i > 0 && !(p.master > points[i - 1].master))
      throw InputError(
          point_key(i, "master"), p.master,
          "must be greater than " + number(points[i - 1].master) + ", the previous point");
  }
}

void cam_detail::give(EnergyKnot& knot, const SplineEnd& end) {
  knot.state[1] = end.geo_velocity.value_or(0);
  knot.state[2] = end.geo_acceleration.value_or(0);
  knot.fixed[1] = end.geo_velocity.has_value();
  knot.fixed[2] = end.geo_acceleration.has_value();
}

void cam_detail::require_ends(const SplineSpec& spec) {
  const bool natural = spec.ends == SplineEnds::natural;
  require_end("start", spec.start, natural);
  require_end("end", spec.end, natural);
}

std::vector<Segment> cubic_spline(const SplineSpec& spec) {
  cam_detail::require_points(spec.points, 2, false);
  cam_detail::require_ends(spec);
  refuse_acceleration("start", spec.start);
  refuse_acceleration("end", spec.end);
  if (spec.ends == SplineEnds::not_a_knot) return not_a_knot(spec, 3);
  return least(spec, cam_detail::Energy::acceleration);
}

std::vector<Segment> quintic_spline(const SplineSpec& spec) {
  cam_detail::require_points(spec.points, 2, false);
  cam_detail::require_ends(spec);
  if (spec.ends == SplineEnds::not_a_knot) return not_a_knot(spec, 5);
  return least(spec, cam_detail::Energy::jerk);
}

}  // namespace jounce
