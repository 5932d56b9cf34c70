// SPDX-License-Identifier: Apache-2.0
// A placed segment -> its finished segments.
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "jounce/cam/laws/b_spline.hpp"
#include "jounce/cam/laws/smoothing_spline.hpp"
#include "jounce/profiles/detail/tolerances.hpp"
#include "jounce/profiles/error.hpp"

#include "cam/src/design/resolve.hpp"
#include "cam/src/laws/added.hpp"
#include "cam/src/laws/polynomial.hpp"

namespace jounce::cam_detail {
namespace {

/// h rise + ... as in law.hpp. Terms that are zero are omitted, so they cost no digits.
Segment combined(const LawPiece& piece, const Placed& at) {
  const double length = at.length();
  Segment f = scaled(piece.rise, at.to.slave - at.from.slave, at.from.slave);
  const auto add = [&](const Segment& shape, double factor) {
    if (factor != 0) f = cam_detail::added(f, scaled(shape, factor));
  };
  add(piece.enter, at.from.geo_velocity.value_or(0) * length);
  add(piece.leave, at.to.geo_velocity.value_or(0) * length);
  add(piece.bend_in, at.from.geo_acceleration.value_or(0) * length * length);
  add(piece.bend_out, at.to.geo_acceleration.value_or(0) * length * length);
  add(piece.jerk_in, at.from.geo_jerk.value_or(0) * length * length * length);
  add(piece.jerk_out, at.to.geo_jerk.value_or(0) * length * length * length);
  f.length *= length;
  return f;
}

/// An R-U or G-U law backwards, from the reversal to the rest or to the velocity.
std::vector<LawPiece> reversed(const std::vector<LawPiece>& law) {
  std::vector<LawPiece> back(law.rbegin(), law.rend());
  for (LawPiece& piece : back) {
    piece.rise = scaled(jounce::reversed(piece.rise), -1, 1);
    std::swap(piece.enter, piece.leave);
    piece.leave = scaled(jounce::reversed(piece.leave), -1);
  }
  return back;
}

std::vector<Segment> through_points(const Placed& at) {
  std::vector<Condition> conditions;
  const auto add = [&](double master, int order, const std::optional<double>& value) {
    if (value) conditions.push_back({master - at.from.master, order, *value});
  };
  for (const CamKnot* knot : {&at.from, &at.to}) {
    add(knot->master, 0, knot->slave);
    add(knot->master, 1, knot->geo_velocity);
    add(knot->master, 2, knot->geo_acceleration);
  }
  for (const CamPoint& point : at.spec->points) {
    if (point.tolerance != 0)
      throw InputError(
          "points.tolerance", point.tolerance,
          "a polynomial passes through its points exactly: use `quintic_spline` for a tolerance");
    add(point.master, 0, point.slave);
    add(point.master, 1, point.geo_velocity);
    add(point.master, 2, point.geo_acceleration);
    add(point.master, 3, point.geo_jerk);
  }
  return {polynomial(at.length(), conditions)};
}

void require_spline_point(Law law, const CamPoint& point, const std::string& key) {
  if (!point.slave)
    throw InputError(key + "slave", "", "is missing: a spline needs the position at each point");
  for (const auto& [name, value] : {std::pair{"geo_velocity", point.geo_velocity},
                                    {"geo_acceleration", point.geo_acceleration},
                                    {"geo_jerk", point.geo_jerk}})
    if (value)
      throw InputError(key + name, *value,
                       "a spline takes positions only: use the law `polynomial` for this");
  require_not_negative((key + "tolerance").c_str(), point.tolerance);
  if (law == Law::cubic_spline && point.tolerance > 0)
    throw InputError(
        key + "tolerance", point.tolerance,
        "a cubic spline passes through its points exactly: use `quintic_spline` for a tolerance");
}

SplineSpec spline_spec(const Placed& at) {
  SplineSpec spline{.points = {{at.from.master, at.from.slave}}};
  for (std::size_t i = 0; i < at.spec->points.size(); ++i) {
    const CamPoint& point = at.spec->points[i];
    require_spline_point(at.spec->law, point, "points[" + std::to_string(i + 1) + "].");
    spline.points.push_back({point.master, *point.slave, point.tolerance});
  }
  spline.points.push_back({at.to.master, at.to.slave});
  const bool open = !at.from.geo_velocity && !at.to.geo_velocity && !at.from.geo_acceleration &&
                    !at.to.geo_acceleration;
  if (at.closed && open) {
    spline.ends = SplineEnds::periodic;
    return spline;
  }
  spline.start.geo_velocity = at.from.geo_velocity;
  spline.end.geo_velocity = at.to.geo_velocity;
  if (at.spec->law == Law::cubic_spline) return spline;
  spline.start.geo_acceleration = at.from.geo_acceleration;
  spline.end.geo_acceleration = at.to.geo_acceleration;
  return spline;
}

std::vector<Segment> splined(const Placed& at) {
  const SplineSpec spline = spline_spec(at);
  const bool exact = std::all_of(spline.points.begin(), spline.points.end(),
                                 [](const SplinePoint& p) { return p.tolerance == 0; });
  if (at.spec->law == Law::cubic_spline) return cubic_spline(spline);
  return exact ? quintic_spline(spline) : smoothing_spline(spline).segments;
}

/// Requires a control value at an end to be the slave position of the knot.
void require_at_knot(std::size_t number, double given, const CamKnot& knot, double size) {
  if (std::abs(given - knot.slave) > profiles_detail::rounded_input * size)
    throw InputError("control[" + std::to_string(number) + "]", given,
                     "must be " + jounce::number(knot.slave) +
                         ", the slave position of the knot at this end of the segment");
}

void require_inside(const std::vector<double>& knots, const Placed& at) {
  double before = at.from.master;
  for (std::size_t i = 0; i < knots.size(); ++i) {
    const double knot = knots[i];
    if (!(knot > at.from.master && knot < at.to.master && knot >= before))
      throw InputError(
          "knots[" + std::to_string(i + 1) + "]", knot,
          "must ascend inside the segment, from " + number(before) + " to " + number(at.to.master));
    before = knot;
  }
}

/// The law b_spline. Its control values determine also the derivatives at its ends.
std::vector<Segment> controlled(const Placed& at) {
  constexpr std::size_t most = 11;
  const auto& [values, inner] = at.spec->control;
  const std::size_t least = inner.size() + 2;
  if (values.size() < least || values.size() > least + most - 1)
    throw InputError("control", std::to_string(values.size()) + " values",
                     "must be " + std::to_string(least) + " to " +
                         std::to_string(least + most - 1) + " values with " +
                         std::to_string(inner.size()) +
                         " inner knots, because the degree is values - knots - 1, from 1 to 11");
  require_inside(inner, at);
  BSplineSpec spec{static_cast<int>(values.size() - inner.size() - 1), {}, values};
  const auto end = static_cast<std::size_t>(spec.degree) + 1;
  spec.knots.assign(end, at.from.master);
  spec.knots.insert(spec.knots.end(), inner.begin(), inner.end());
  spec.knots.insert(spec.knots.end(), end, at.to.master);
  const double size = std::max(std::abs(at.from.slave), std::abs(at.to.slave));
  require_at_knot(1, values.front(), at.from, size);
  require_at_knot(values.size(), values.back(), at.to, size);
  return b_spline(spec);
}

std::vector<Segment> by_law(const Placed& at) {
  const Law law = at.spec->law;
  const CamKnot& a = at.from;
  const CamKnot& b = at.to;
  if (law == Law::quintic)
    return {quintic(at.length(), a.slave, a.geo_velocity.value_or(0),
                    a.geo_acceleration.value_or(0), b.slave, b.geo_velocity.value_or(0),
                    b.geo_acceleration.value_or(0))};
  if (law == Law::line || law == Law::dwell) return {line(at.length(), a.slave, b.slave)};
  if (law == Law::polynomial) return through_points(at);
  if (law == Law::hermite) return through_hermite_points(at);
  if (law == Law::b_spline) return controlled(at);
  if (is_spline(law)) return splined(at);
  std::vector<Segment> segments;
  for (const LawPiece& piece : shapes(at)) segments.push_back(combined(piece, at));
  return segments;
}

}  // namespace

std::vector<LawPiece> shapes(const Placed& at) {
  const auto law = pieces(at.spec->law, at.form);
  return at.reversed ? reversed(law) : law;
}

std::vector<Segment> built(const Placed& at) {
  try {
    return by_law(at);
  } catch (const InputError& error) {
    throw InputError("segment[" + std::to_string(at.index + 1) + "]." + error.key(), error.value(),
                     error.rule());
  }
}

}  // namespace jounce::cam_detail
