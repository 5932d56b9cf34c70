// SPDX-License-Identifier: Apache-2.0
#include "cam/src/fit/spline_part.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>
#include <utility>

#include "jounce/cam/laws/smoothing_spline.hpp"

namespace jounce::cam_detail {
namespace {

/// Share of a tolerance that the smoothest curve may use. The rest is for rounded values.
constexpr double used_share = 0.95;

double at(const std::vector<Segment>& segments, double start, double master) {
  return Cam(segments, start).jet(master)[0];
}

bool is_straight(const CamSpec& spec, std::size_t i) {
  return i < spec.segments.size() &&
         (spec.segments[i].law == Law::dwell || spec.segments[i].law == Law::line);
}

/// The smoothest curve over a segment of the spec.
SplineSpec spline_of(const CamSpec& spec, std::size_t i, const MeasuredCam& measured) {
  const CamKnot& from = knot(spec, i);
  const CamKnot& to = knot(spec, i + 1);
  SplineSpec spline{.points = {{from.master, from.slave, 0}}};
  for (const SplinePoint& p : measured.points)
    if (p.master > from.master && p.master < to.master)
      spline.points.push_back({p.master, p.slave, used_share * p.tolerance});
  spline.points.push_back({to.master, to.slave, 0});
  return spline;
}

SplineEnd end_of(const CamKnot& resolved) {
  return {resolved.geo_velocity, resolved.geo_acceleration};
}

/// Knots of the spec with the derivatives that the neighbors of a segment require. An open end of
/// the cam has none.
std::pair<SplineEnd, SplineEnd> ends_of(const CamSpec& spec, std::size_t i) {
  const std::vector<CamKnot> all = resolved_knots(spec);
  const auto open = [&](std::size_t k) {
    const bool outer = k == 0 || k + 1 == all.size();
    return outer && !spec.periodic && !knot(spec, k).geo_velocity;
  };
  return {open(i) ? SplineEnd{} : end_of(all[i]), open(i + 1) ? SplineEnd{} : end_of(all[i + 1])};
}

/// Gives a knot of a segment the derivatives of its curve, unless a line or a dwell on the other
/// side of the knot gives them. `k`: number of the knot.
void give(CamSpec& spec, std::size_t k, bool at_start, const SplineEnd& end) {
  const std::size_t last = spec.segments.size();
  const bool seam = k == 0 || k == last;
  if (!end.geo_velocity || (seam && !spec.periodic)) return;
  const std::size_t beside = at_start ? (k == 0 ? last : k) - 1 : k % last;
  if (is_straight(spec, beside)) return;
  for (const std::size_t same : seam ? std::vector{std::size_t{0}, last} : std::vector{k}) {
    knot(spec, same).geo_velocity = end.geo_velocity;
    knot(spec, same).geo_acceleration = end.geo_acceleration;
  }
}

/// Writes the curve into the segment: as a quintic, if the curve has no joint and both ends are
/// given.
void write_spline(CamSpec& spec, std::size_t i, const SplineSpec& spline,
                  const SmoothingSpline& curve) {
  CamSegment& segment = spec.segments[i];
  segment.points.clear();
  for (const std::size_t joint : curve.touched) {
    if (joint == 0 || joint + 1 == spline.points.size()) continue;
    const double master = spline.points[joint].master;
    segment.points.push_back(
        {.master = master, .slave = at(curve.segments, spline.points[0].master, master)});
  }
  const bool clamped = spline.start.geo_velocity && spline.end.geo_velocity;
  segment.law = segment.points.empty() && clamped ? Law::quintic : Law::quintic_spline;
  give(spec, i, true, spline.start);
  give(spec, i + 1, false, spline.end);
}

std::vector<std::size_t> points_in(const MeasuredCam& measured, double from, double to) {
  std::vector<std::size_t> inside;
  for (std::size_t k = 0; k < measured.points.size(); ++k)
    if (measured.points[k].master >= from && measured.points[k].master <= to) inside.push_back(k);
  return inside;
}

/// Leaves out points of the spline that the tolerances do not need.
void leave_out_points(CamSpec& spec, std::size_t i, const MeasuredCam& measured) {
  constexpr std::size_t most_points = 60;  // the time grows with the square of their number
  if (spec.segments[i].points.size() > most_points) return;
  const auto inside = points_in(measured, knot(spec, i).master, knot(spec, i + 1).master);
  for (bool again = true; again;) {
    again = false;
    CamSpec best;
    double least = used_share;
    for (std::size_t p = 0; p < spec.segments[i].points.size(); ++p) {
      CamSpec trial = spec;
      auto& points = trial.segments[i].points;
      points.erase(points.begin() + static_cast<std::ptrdiff_t>(p));
      if (points.empty()) continue;
      const double worst = deviation(trial, measured, inside).worst;
      if (worst > least) continue;
      least = worst;
      best = std::move(trial);
      again = true;
    }
    if (again) spec = std::move(best);
  }
}

/// The spec with a longer motion at the expense of the dwells and lines beside it. `share`: of the
/// motion.
CamSpec lengthened(CamSpec spec, std::size_t i, double share) {
  const double by = share * (knot(spec, i + 1).master - knot(spec, i).master);
  const auto move = [&](std::size_t moved, std::size_t other) {
    CamKnot& k = knot(spec, moved);
    const CamKnot& far = knot(spec, other);
    const double part = std::min(by / std::abs(far.master - k.master), 0.5);
    k.master += part * (far.master - k.master);
    if (far.slave != k.slave) k.slave += part * (far.slave - k.slave);
  };
  if (i > 0 && is_straight(spec, i - 1)) move(i, i - 1);
  if (is_straight(spec, i + 1)) move(i + 1, i + 2);
  return spec;
}

}  // namespace

void spline_part(CamSpec& spec, std::size_t i, const MeasuredCam& measured) {
  const bool before = i > 0 && is_straight(spec, i - 1);
  const bool after = is_straight(spec, i + 1);
  const auto near = points_in(measured, knot(spec, before ? i - 1 : i).master,
                              knot(spec, after ? i + 2 : i + 1).master);
  std::optional<CamSpec> best;
  bool best_fits = false;
  for (const double share : {0.0, 0.02, 0.05, 0.1, 0.2}) {
    CamSpec trial = lengthened(spec, i, share);
    SplineSpec spline = spline_of(trial, i, measured);
    std::tie(spline.start, spline.end) = ends_of(trial, i);
    if (spline.points.size() < 3) {
      trial.segments[i].law = Law::quintic;
    } else {
      write_spline(trial, i, spline, smoothing_spline(spline));
      leave_out_points(trial, i, measured);
    }
    const bool fits =
        deviation(trial, measured, near).fits() && !oscillation(trial, measured, near);
    const bool fewer = best && trial.segments[i].points.size() < best->segments[i].points.size();
    if (best && (fits == best_fits ? !fewer : best_fits)) continue;
    best = std::move(trial);
    best_fits = fits;
  }
  spec = std::move(*best);
}

void close_with_spline(CamSpec& spec, const MeasuredCam& measured) {
  SplineSpec whole{.points = measured.points, .ends = SplineEnds::periodic};
  for (SplinePoint& p : whole.points) p.tolerance *= used_share;
  const double middle = (whole.points.front().slave + whole.points.back().slave) / 2;
  if (!spec.slave_period) whole.points.front().slave = whole.points.back().slave = middle;
  whole.points.back().tolerance = whole.points.front().tolerance;
  const Segment first = smoothing_spline(whole).segments.front();
  const Jet jet = evaluate(first, 0);
  const double travel = knot(spec, spec.segments.size()).slave - spec.start.slave;
  for (const std::size_t k : {std::size_t{0}, spec.segments.size()}) {
    CamKnot& end = knot(spec, k);
    end.slave = jet[0] + (k == 0 ? 0 : travel);
    end.geo_velocity = jet[1];
    end.geo_acceleration = jet[2];
  }
}

CamSpec one_spline(const MeasuredCam& measured) {
  const SplinePoint& from = measured.points.front();
  const SplinePoint& to = measured.points.back();
  CamSpec spec{.start = {from.master, from.slave},
               .segments = {{.law = Law::quintic_spline, .end = {to.master, to.slave}}},
               .periodic = measured.periodic};
  if (measured.periodic) {
    if (std::abs(to.slave - from.slave) > from.tolerance + to.tolerance)
      spec.slave_period = std::abs(to.slave - from.slave);
    else
      spec.segments[0].end.slave = from.slave;
    close_with_spline(spec, measured);
  }
  spline_part(spec, 0, measured);
  return spec;
}

}  // namespace jounce::cam_detail
