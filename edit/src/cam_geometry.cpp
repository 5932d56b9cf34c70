// SPDX-License-Identifier: Apache-2.0
#include "edit/src/cam_geometry.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "jounce/profiles/error.hpp"

namespace jounce::edit_detail {
namespace {

constexpr double same_slope = 1e-9;  ///< share of a slope within which two slopes are the same

std::string segment_key(std::size_t i) {
  return "segment[" + std::to_string(i + 1) + "]";
}

/// The two laws next to a knot; a knot at an end of a cam without a period has one.
std::vector<Law> laws_beside(const CamSpec& cam, std::size_t knot) {
  std::vector<Law> laws;
  const std::size_t last = cam.segments.size();
  if (knot > 0 || cam.periodic) laws.push_back(cam.segments[(knot > 0 ? knot : last) - 1].law);
  if (knot < last || cam.periodic) laws.push_back(cam.segments[knot < last ? knot : 0].law);
  return laws;
}

/// Marks the knots that keep their slave position relative to this one.
std::vector<bool> joined_with(const CamSpec& cam, std::size_t knot) {
  const std::size_t last = cam.segments.size();
  std::vector<bool> joined(last + 1, false);
  joined[knot] = true;
  for (bool more = true; more;) {
    more = false;
    const auto join = [&](std::size_t a, std::size_t b) {
      if (joined[a] == joined[b]) return;
      joined[a] = joined[b] = more = true;
    };
    for (std::size_t i = 0; i < last; ++i)
      if (cam.segments[i].law == Law::dwell) join(i, i + 1);
    if (cam.periodic) join(0, last);
  }
  return joined;
}

double slope(const CamSpec& cam, std::size_t i) {
  const CamKnot& a = knot_of(cam, i);
  const CamKnot& b = knot_of(cam, i + 1);
  return (b.slave - a.slave) / (b.master - a.master);
}

/// Gives the knots of each line its new slope where they gave the old one.
void follow_lines(CamSpec& cam, const CamSpec& before) {
  for (std::size_t i = 0; i < cam.segments.size(); ++i) {
    if (cam.segments[i].law != Law::line) continue;
    const double was = slope(before, i);
    const double is = slope(cam, i);
    for (const std::size_t k : {i, i + 1}) {
      std::optional<double>& given = knot_of(cam, k).geo_velocity;
      if (given && was != is && std::abs(*given - was) <= same_slope * std::abs(was)) given = is;
    }
  }
}

/// Calls `change` for all knots and points.
template <class Change>
void for_all(CamSpec& cam, Change change) {
  change(cam.start);
  for (CamSegment& segment : cam.segments) {
    change(segment.end);
    for (CamPoint& point : segment.points) change(point);
  }
}

void multiply(std::optional<double>& value, double factor) {
  if (value) *value *= factor;
}

void refuse_points(const CamSpec& cam, std::size_t i) {
  if (!cam.segments[i].points.empty() || !has_own_shape(cam.segments[i].law))
    throw InputError(segment_key(i) + ".points", "",
                     "must be changed as text: the law goes through points");
}

}  // namespace

const CamKnot& knot_of(const CamSpec& cam, std::size_t knot) {
  return knot == 0 ? cam.start : cam.segments[knot - 1].end;
}
CamKnot& knot_of(CamSpec& cam, std::size_t knot) {
  return knot == 0 ? cam.start : cam.segments[knot - 1].end;
}

Settable settable_at(const CamSpec& cam, std::size_t knot) {
  Settable settable{true, true};
  for (const Law law : laws_beside(cam, knot)) {
    const Ends ends = info(law).ends;
    settable.velocity = settable.velocity &&
                        (ends == Ends::given || ends == Ends::moving || ends == Ends::moving_free);
    settable.acceleration = settable.acceleration && ends == Ends::given;
  }
  return settable;
}

CamSpec moved(CamSpec cam, std::size_t knot, double master, double slave) {
  const CamSpec before = cam;
  const std::vector<bool> joined = joined_with(cam, knot);
  const double was = knot_of(cam, knot).slave;
  for (std::size_t k = 0; k < joined.size(); ++k)
    if (joined[k]) {
      double& position = knot_of(cam, k).slave;
      position = position == was ? slave : position + (slave - was);
    }
  knot_of(cam, knot).master = master;
  follow_lines(cam, before);
  return cam;
}

CamSpec with_slave(CamSpec cam, const Affine& change) {
  for_all(cam, [&](auto& at) {
    if constexpr (std::is_same_v<decltype(at.slave), double>)
      at.slave = change.scale * at.slave + change.shift;
    else if (at.slave)
      at.slave = change.scale * *at.slave + change.shift;
    multiply(at.geo_velocity, change.scale);
    multiply(at.geo_acceleration, change.scale);
    multiply(at.geo_jerk, change.scale);
    if constexpr (requires { at.tolerance; }) at.tolerance *= std::abs(change.scale);
  });
  for (CamSegment& segment : cam.segments)
    for (double& value : segment.control.values) value = change.scale * value + change.shift;
  return cam;
}

CamSpec with_master(CamSpec cam, const Affine& change) {
  const double k = 1 / change.scale;
  for_all(cam, [&](auto& at) {
    at.master = change.scale * at.master + change.shift;
    multiply(at.geo_velocity, k);
    multiply(at.geo_acceleration, k * k);
    multiply(at.geo_jerk, k * k * k);
  });
  for (CamSegment& segment : cam.segments)
    for (double& knot : segment.control.knots) knot = change.scale * knot + change.shift;
  return cam;
}

CamSpec mirrored_slave(const CamSpec& cam) {
  double low = cam.start.slave;
  double high = low;
  for (const CamSegment& segment : cam.segments) {
    low = std::min(low, segment.end.slave);
    high = std::max(high, segment.end.slave);
  }
  return with_slave(cam, {-1, low + high});
}

CamSpec mirrored_master(const CamSpec& cam) {
  const std::size_t n = cam.segments.size();
  for (std::size_t i = 0; i < n; ++i) refuse_points(cam, i);
  const double sum = cam.start.master + cam.segments.back().end.master;
  const auto reversed = [&](CamKnot knot) {
    knot.master = sum - knot.master;
    multiply(knot.geo_velocity, -1);
    multiply(knot.geo_jerk, -1);
    return knot;
  };
  CamSpec out = cam;
  out.start = reversed(knot_of(cam, n));
  for (std::size_t i = 0; i < n; ++i) {
    CamSegment& segment = out.segments[i];
    segment = cam.segments[n - 1 - i];
    segment.end = reversed(knot_of(cam, n - 1 - i));
    if (segment.form.inflection) segment.form.inflection = 1 - *segment.form.inflection;
  }
  return out;
}

Split split(const CamSpec& cam, const Cam& curve, double master) {
  const std::size_t n = cam.segments.size();
  if (!(master > cam.start.master && master < knot_of(cam, n).master))
    throw InputError("master", master, "must be inside the cam");
  std::size_t i = 0;
  while (knot_of(cam, i + 1).master < master) ++i;
  if (knot_of(cam, i + 1).master == master)
    throw InputError("master", master, "is the position of a knot");
  refuse_points(cam, i);
  const Jet at = curve.jet(master);
  Split halves{i, cam.segments[i], cam};
  CamSegment& second = halves.cam.segments[i];
  halves.first.end = {master, at[0]};
  const Ends ends = info(second.law).ends;
  const bool plain = ends == Ends::straight || ends == Ends::standing;
  if (!plain) {
    halves.first.end.geo_velocity = at[1];
    halves.first.end.geo_acceleration = at[2];
  }
  if (!plain && ends != Ends::given) {
    halves.first.law = second.law = Law::quintic;
    halves.first.form = second.form = {};
  }
  halves.first.name.clear();
  return halves;
}

}  // namespace jounce::edit_detail
