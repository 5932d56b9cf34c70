// SPDX-License-Identifier: Apache-2.0
// From a shape to the points of laws `hermite`, and to the knots that were free.
#include <algorithm>

#include "optimize/src/shapes/cam_run.hpp"

namespace jounce::optimize_detail {
namespace {

constexpr double same_knot =
    1e-9;  // share of the run: a break of the spline this near to a knot is the knot

Jet jet_at(const Trajectory& curve, double x) {
  return curve.jet(std::clamp(x, curve.start(), curve.end()),
                   x >= curve.end() ? Side::left : Side::right);
}

/// Both ends of a closed run are one knot, with derivatives that are equal to the last digit.
Jet jet_at(const Trajectory& curve, const CamRunOf& run, const RunKnot& knot) {
  const bool last = run.closed && knot.x() == run.knots.back().x();
  Jet f = jet_at(curve, last ? curve.start() : knot.x());
  if (last) f[0] += run.advance;
  return f;
}

CamPoint point_at(const Jet& f, double master, bool jerk) {
  CamPoint point{.master = master, .slave = f[0], .geo_velocity = f[1], .geo_acceleration = f[2]};
  if (jerk) point.geo_jerk = f[3];
  return point;
}

/// A point at a knot. The knot has the slave. The fixed values are exact to the last digit.
CamPoint point_at(const RunKnot& knot, const Jet& f, double master, bool jerk) {
  CamPoint point = point_at(f, master, jerk);
  point.slave.reset();
  if (knot.geo_velocity) point.geo_velocity = knot.geo_velocity;
  if (knot.geo_acceleration) point.geo_acceleration = knot.geo_acceleration;
  if (jerk && knot.geo_jerk) point.geo_jerk = knot.geo_jerk;
  return point;
}

const CamKnot& knot_of(const CamSpec& cam, std::size_t i) {
  return i == 0 ? cam.start : cam.segments[i - 1].end;
}

/// The points of the run's r-th segment.
std::vector<CamPoint> points_of(const CamSpec& cam, const CamRunOf& run, std::size_t r,
                                const Trajectory& curve, bool jerk) {
  const RunKnot& from = run.knots[r];
  const RunKnot& to = run.knots[r + 1];
  std::vector<CamPoint> points{
      point_at(from, jet_at(curve, run, from), knot_of(cam, run.segments[r]).master, jerk)};
  const double near = same_knot * curve.length();
  for (const double x : curve.breaks()) {
    if (x <= from.x() + near || x >= to.x() - near) continue;
    CamPoint point = point_at(jet_at(curve, x), x - to.ahead, jerk);
    *point.slave -= to.auxiliary;
    points.push_back(point);
  }
  points.push_back(point_at(to, jet_at(curve, run, to), to.master, jerk));
  return points;
}

void take(CamKnot& knot, const FreeKnot& free, const Jet& f, double auxiliary) {
  if (free.slave) knot.slave = f[0] - auxiliary;
  if (free.geo_velocity && knot.geo_velocity) knot.geo_velocity = f[1];
  if (free.geo_acceleration && knot.geo_acceleration) knot.geo_acceleration = f[2];
}

/// Writes the free values of a knot. The start and the last knot of a periodic cam are one.
void take(CamSpec& cam, const RunKnot& knot, const CamRunOf& run, const Jet& f) {
  const std::size_t last = cam.segments.size();
  const bool seam = cam.periodic && knot.knot % last == 0;
  if (!seam) {
    take(knot.knot == 0 ? cam.start : cam.segments[knot.knot - 1].end, knot.free, f,
         knot.auxiliary);
    return;
  }
  const double at_start = knot.knot == 0 ? knot.auxiliary : knot.auxiliary + run.advance;
  take(cam.start, knot.free, f, at_start);
  take(cam.segments.back().end, knot.free, f, at_start - run.advance);
}

}  // namespace

CamSpec with_shape(CamSpec cam, const CamRunOf& run, const ShapeProblem& problem,
                   const std::vector<Segment>& shape) {
  const Trajectory curve(shape, problem.begin, Extrapolation::hold);
  const bool jerk = problem.degree > 5;
  for (std::size_t r = 0; r < run.segments.size(); ++r) {
    const std::size_t i = run.segments[r];
    auto points = points_of(cam, run, r, curve, jerk);
    cam.segments[i] = {
        Law::hermite, cam.segments[i].end, cam.segments[i].name, {}, std::move(points)};
  }
  for (const RunKnot& knot : run.knots) take(cam, knot, run, jet_at(curve, run, knot));
  return cam;
}

}  // namespace jounce::optimize_detail
