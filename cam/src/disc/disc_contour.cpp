// SPDX-License-Identifier: Apache-2.0
#include "jounce/cam/disc/disc_contour.hpp"

#include <cmath>

#include "jounce/profiles/detail/six_digits.hpp"
#include "jounce/profiles/detail/tolerances.hpp"
#include "jounce/profiles/error.hpp"

#include "cam/src/disc/pitch.hpp"

// An interval of the curve p over the angle w = 2k, from a through the midpoint m to b:
//
//   (1)  a line from p(a) to p(b) is nowhere further from p than  max|p''| w^2 / 8
//
//   (2)  the circle (c, R) through p(a), p(m), p(b): g = |p - c|^2 - R^2 vanishes at all three, so
//            |g| <= max|g'''|/6  max|x (x^2 - k^2)| = max|g'''|/6  2 k^3 / (3 sqrt 3)
//        and | |p - c| - R | <= tol where |g| <= tol (2R - tol), R > tol
//
// An arc is permitted only if p' has a positive component along the chord throughout: p then never
// passes the arc's ends. g is enclosed in the fixed frame, in which a dwell is one point.

namespace jounce {
namespace {

using profiles_detail::rounded_input;

using cam_detail::Interval;
using cam_detail::Plane;
using cam_detail::SegmentPart;
using cam_detail::Taylor;

/// Sine of an angle: three points with a smaller one have no circle.
constexpr double on_a_line = 1e-6;
constexpr double shortest_arc = 1e-12;    ///< share of a segment: a shorter arc is not divided
constexpr double finest_contour = 1e-10;  ///< share of the size of the cam

struct Circle {
  Place center;
  double radius = 0;
  double bulge = 0;
};

/// The circle through a, m and b; nullopt if the points are nearly on a line.
std::optional<Circle> through(const Vertex& a, const Vertex& m, const Vertex& b) {
  const Place u{m.x - a.x, m.y - a.y};
  const Place v{b.x - a.x, b.y - a.y};
  const double uu = u.x * u.x + u.y * u.y;
  const double vv = v.x * v.x + v.y * v.y;
  const double twice = 2 * (u.x * v.y - u.y * v.x);
  if (!(std::abs(twice) > on_a_line * vv)) return std::nullopt;
  const Place c{(uu * v.y - vv * u.y) / twice, (vv * u.x - uu * v.x) / twice};
  const double radius = std::hypot(c.x, c.y);
  const double half = std::min(1.0, std::sqrt(vv) / (2 * radius));  // sine of half the angle
  const double bulge = half / (1 + std::sqrt(1 - half * half));
  return Circle{{a.x + c.x, a.y + c.y}, radius, std::copysign(bulge, twice)};
}

class Flattening {
 public:
  Flattening(const Disc& disc, double distance, double tolerance, Pieces pieces)
      : disc_(disc), distance_(distance), tolerance_(tolerance), pieces_(pieces) {
    for (std::size_t i = 0; i < disc.lift().segments().size(); ++i) run({i, 0, 1});
  }

  [[nodiscard]] Contour contour() && { return std::move(contour_); }

 private:
  [[nodiscard]] Vertex vertex(std::size_t segment, double s) const {
    const Plane<3> p = seen({segment, s, s});
    return {p.x.c[0].middle(), p.y.c[0].middle(), 0,
            cam_detail::position(disc_.lift(), segment, s)};
  }

  [[nodiscard]] Plane<3> seen(const SegmentPart& over) const {
    const cam_detail::Pitch pitch = cam_detail::pitch(disc_, over);
    return cam_detail::seen_from_cam(pitch.parallel(distance_), cam_detail::turned<3>(disc_, over),
                                     pitch.sigma);
  }

  [[nodiscard]] double half_width(const SegmentPart& over) const {
    return (over.s1 - over.s0) / 2 * disc_.lift().segments()[over.segment].length *
           disc_.spec().angle;
  }

  void run(const SegmentPart& over) {
    Vertex a = vertex(over.segment, over.s0);
    const Vertex b = vertex(over.segment, over.s1);
    const Plane<3> p = seen(over);
    if (const auto bulge = arc(over, a, b, p)) {
      a.bulge = *bulge;
      contour_.push_back(a);
    } else if (is_line(over, p) || over.s1 - over.s0 < shortest_arc) {
      contour_.push_back(a);
    } else {
      run(over.left());
      run(over.right());
    }
  }

  /// Equation (1).
  [[nodiscard]] bool is_line(const SegmentPart& over, const Plane<3>& p) const {
    const double k = half_width(over);
    const double second = 2 * std::hypot(p.x.c[2].magnitude(), p.y.c[2].magnitude());
    return second * k * k / 2 <= tolerance_;
  }

  /// Equation (2).
  [[nodiscard]] std::optional<double> arc(const SegmentPart& over, const Vertex& a, const Vertex& b,
                                          const Plane<3>& p) const {
    if (pieces_ == Pieces::lines) return std::nullopt;
    const Interval along = Interval(b.x - a.x) * p.x.c[1] + Interval(b.y - a.y) * p.y.c[1];
    if (!(along.lo > 0)) return std::nullopt;
    const auto circle = through(a, vertex(over.segment, over.middle()), b);
    if (!circle || !(circle->radius > tolerance_)) return std::nullopt;
    const cam_detail::Pitch pitch = cam_detail::pitch(disc_, over);
    const Plane<3> center = cam_detail::seen_from_cam(
        Plane<3>{Taylor<3>(circle->center.x), Taylor<3>(circle->center.y)},
        cam_detail::turned<3>(disc_, over), -pitch.sigma);
    const Plane<3> from = pitch.parallel(distance_) - center;
    const double third = (square(from.x) + square(from.y)).c[3].magnitude();
    const double k = half_width(over);
    const double g = third * 2 * k * k * k / (3 * std::numbers::sqrt3);
    if (!(g <= tolerance_ * (2 * circle->radius - tolerance_))) return std::nullopt;
    return circle->bulge;
  }

  const Disc& disc_;
  double distance_;
  double tolerance_;
  Pieces pieces_;
  Contour contour_;
};

void require_tolerance(const Disc& disc, double distance, double tolerance) {
  require_positive("tolerance", tolerance);
  const double size = disc.spec().base_radius + disc.spec().roller_radius +
                      extrema(disc.lift(), 0).max.value + std::abs(distance);
  if (!(tolerance >= finest_contour * size))
    throw InputError(
        "tolerance", tolerance,
        "must be at least " + six_digits_up(finest_contour * size) + ", 1e-10 of the cam's size");
}

}  // namespace

Contour contour(const Disc& disc, double distance, double tolerance, Pieces pieces) {
  require_finite("distance", distance);
  require_tolerance(disc, distance, tolerance);
  const Jump jump = largest_jump(disc.lift(), 1);
  if (std::abs(jump.step) > rounded_input * std::abs(extrema(disc.lift(), 1).peak().value))
    throw InputError("cam", six_digits(jump.step),
                     "is a step of the velocity at master " + six_digits(jump.where) +
                         ": the contour would have a corner there, which no roller can follow. Use "
                         "a law with a continuous velocity");
  return Flattening(disc, distance, tolerance, pieces).contour();
}

}  // namespace jounce
