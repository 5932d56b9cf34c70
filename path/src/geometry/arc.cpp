// SPDX-License-Identifier: Apache-2.0
#include "jounce/path/arc.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <string>

#include "jounce/profiles/detail/numeric.hpp"
#include "jounce/profiles/detail/six_digits.hpp"
#include "jounce/profiles/detail/tolerances.hpp"
#include "jounce/profiles/error.hpp"

#include "path/src/geometry/vector.hpp"

namespace jounce {
namespace {

using profiles_detail::rounded_digit;
// Relative tolerance for coincident points, and for a chord of twice the radius.
constexpr double coincident = 1e-9;

void require_axes(Plane plane) {
  if (plane.first >= max_axes || plane.second >= max_axes || plane.first == plane.second)
    throw InputError("plane", std::to_string(plane.first) + ", " + std::to_string(plane.second),
                     "must be two different axes, counted from 0");
}

void require_turns(int extra_turns) {
  if (extra_turns < 0)
    throw InputError("turns", std::to_string(extra_turns), "extra turns must not be negative");
}

void require_finite_point(const char* key, const Point& p) {
  for (const double x : p) require_finite(key, x);
}

/// The components in a plane; all others are 0.
Point in_plane(const Point& p, Plane plane) {
  Point q{};
  q[plane.first] = p[plane.first];
  q[plane.second] = p[plane.second];
  return q;
}

/// The coordinates in a plane: "(30, 25)".
std::string shown(const Point& p, Plane plane) {
  return "(" + six_digits(p[plane.first]) + ", " + six_digits(p[plane.second]) + ")";
}

/// e1 rotated by 90 degrees in a plane, in the direction of rotation.
Point turned(const Point& e1, Plane plane, double sense) {
  Point e2{};
  e2[plane.first] = -sense * e1[plane.second];
  e2[plane.second] = sense * e1[plane.first];
  return e2;
}

/// Angle from the start to a vector from the center, in [0, 2 pi).
double angle_to(const Arc& arc, const Point& v) {
  const double angle = std::atan2(vec::dot(v, arc.e2), vec::dot(v, arc.e1));
  return angle < 0 ? angle + profiles_detail::two_pi : angle;
}

/// The arc in a plane around `center`, from which both ends have the same distance.
Arc planar(const Point& from, const Point& center, const Point& to, Plane plane,
           ArcRotation rotation, int extra_turns) {
  const double sense = rotation == ArcRotation::counterclockwise ? 1 : -1;
  Arc arc;
  const Point spoke = in_plane(vec::difference(from, center), plane);
  arc.radius = vec::norm(spoke);
  arc.e1 = vec::scaled(spoke, 1 / arc.radius);
  arc.e2 = turned(arc.e1, plane, sense);
  arc.center = from;
  arc.center[plane.first] = center[plane.first];
  arc.center[plane.second] = center[plane.second];
  const Point chord = in_plane(vec::difference(to, from), plane);
  const bool full = vec::norm(chord) <= coincident * arc.radius;
  arc.sweep =
      full ? profiles_detail::two_pi : angle_to(arc, in_plane(vec::difference(to, center), plane));
  arc.sweep += profiles_detail::two_pi * extra_turns;
  arc.drift = vec::difference(to, from);
  arc.drift[plane.first] = arc.drift[plane.second] = 0;
  arc.to = to;
  return arc;
}

}  // namespace

Arc arc_through(const Point& from, const Point& via, const Point& to, std::size_t axes,
                int extra_turns) {
  if (axes < 2 || axes > max_axes)
    throw InputError("axes", std::to_string(axes), "an arc needs 2 to 9 axes");
  require_turns(extra_turns);
  for (const Point* p : {&from, &via, &to}) require_finite_point("via", *p);
  const Point a = vec::first(vec::difference(via, from), axes);
  const Point b = vec::first(vec::difference(to, from), axes);
  const double aa = vec::dot(a, a, axes);
  const double bb = vec::dot(b, b, axes);
  const double ab = vec::dot(a, b, axes);
  const double largest = std::max(aa, bb);
  const double area2 = aa * bb - ab * ab;  // twice the triangle's area, squared
  if (!(area2 > profiles_detail::square(coincident * largest)) || !(std::min(aa, bb) > 0))
    throw InputError("via", "",
                     "lies on a line with start and end, or coincides with one of them: move it");
  // The center from + x a + y b has the same distance from all three points.
  const double x = bb * (aa - ab) / (2 * area2);
  const double y = aa * (bb - ab) / (2 * area2);
  Arc arc;
  arc.center = vec::sum(vec::sum(from, a, x), b, y);
  const Point spoke = vec::difference(from, arc.center);
  arc.radius = vec::norm(spoke, axes);
  arc.e1 = vec::scaled(spoke, 1 / arc.radius);
  // The side of `via` determines the direction of rotation.
  const Point side = vec::perpendicular(a, arc.e1);
  const Point other = vec::perpendicular(b, arc.e1);
  const Point& e2 = vec::dot(side, side) >= vec::dot(other, other) ? side : other;
  arc.e2 = vec::scaled(e2, 1 / vec::norm(e2));
  const double to_via = angle_to(arc, vec::difference(via, arc.center));
  if (to_via > angle_to(arc, vec::difference(to, arc.center))) arc.e2 = vec::scaled(arc.e2, -1);
  arc.sweep =
      angle_to(arc, vec::difference(to, arc.center)) + profiles_detail::two_pi * extra_turns;
  arc.drift = vec::difference(to, from);
  for (std::size_t i = 0; i < axes; ++i) arc.drift[i] = 0;
  arc.to = to;
  return arc;
}

Arc arc_about(const Point& from, const Point& center, const Point& to, Plane plane,
              ArcRotation rotation, int extra_turns, double tolerance) {
  require_axes(plane);
  require_turns(extra_turns);
  require_not_negative("tolerance", tolerance);
  for (const Point* p : {&from, &center, &to}) require_finite_point("center", *p);
  const Point chord = in_plane(vec::difference(to, from), plane);
  const double c = vec::norm(chord);
  const double r0 = vec::norm(in_plane(vec::difference(from, center), plane));
  const double r1 = vec::norm(in_plane(vec::difference(to, center), plane));
  if (!(std::min(r0, r1) > 0))
    throw InputError("center", "",
                     std::string("is the ") + (r0 > 0 ? "end" : "start") +
                         " of the arc, which has no radius then: correct one of the two points");
  if (std::abs(r0 - r1) > tolerance)
    throw InputError("center", "",
                     "is " + six_digits(r0) + " from the start and " + six_digits(r1) +
                         " from the end, but these radii may differ by at most " +
                         six_digits(tolerance) + ": correct one of the three points");
  if (c <= coincident * r0) return planar(from, center, to, plane, rotation, extra_turns);
  // Moves the center onto the bisector of the chord, by the shortest distance.
  const Point along = vec::scaled(chord, 1 / c);
  const Point middle = vec::sum(from, chord, 0.5);
  const double off = vec::dot(in_plane(vec::difference(center, middle), plane), along);
  const bool moves = std::abs(off) > rounded_digit * r0;
  Arc arc = planar(from, moves ? vec::sum(center, along, -off) : center, to, plane, rotation,
                   extra_turns);
  arc.center_moved = std::abs(off);
  return arc;
}

Arc arc_of_radius(const Point& from, double radius, const Point& to, Plane plane,
                  ArcRotation rotation, int extra_turns) {
  require_axes(plane);
  require_turns(extra_turns);
  require_finite("radius", radius);
  for (const Point* p : {&from, &to}) require_finite_point("to", *p);
  const Point chord = in_plane(vec::difference(to, from), plane);
  const double half = vec::norm(chord) / 2;
  const double r = std::abs(radius);
  // planar() makes a full circle of such ends: its center would be arbitrary.
  if (!(2 * half > coincident * r))
    throw InputError("radius", radius,
                     "does not determine the center, because start and end are the same point: "
                     "give the center for a full circle, or correct the end");
  if (half > r * (1 + coincident))
    throw InputError("radius", radius,
                     "must be at least " + six_digits_up(half) +
                         ", half the distance from the start " + shown(from, plane) +
                         " to the end " + shown(to, plane));
  const double height = std::sqrt(std::max((r - half) * (r + half), 0.0));
  const Point along = vec::scaled(chord, 0.5 / half);
  // Counterclockwise the center of a minor arc lies to the left of the chord.
  const double sense = rotation == ArcRotation::counterclockwise ? 1 : -1;
  const Point left = turned(along, plane, sense);
  const Point center = vec::sum(vec::sum(from, chord, 0.5), left, radius > 0 ? height : -height);
  return planar(from, center, to, plane, rotation, extra_turns);
}

Arc arc_by_angle(const Point& from, const Point& center, double degrees, const Point& to,
                 Plane plane) {
  require_axes(plane);
  require_finite("angle", degrees);
  if (degrees == 0) throw InputError("angle", degrees, "must not be 0");
  Point end = to;
  const double angle = degrees * (std::numbers::pi / 180);
  const Point spoke = in_plane(vec::difference(from, center), plane);
  if (!(vec::norm(spoke) > 0))
    throw InputError("center", "",
                     "is the start of the arc, which has no radius then: correct one of the two "
                     "points");
  const Point across = turned(spoke, plane, 1);
  for (const std::size_t i : {plane.first, plane.second})
    end[i] = center[i] + spoke[i] * std::cos(angle) + across[i] * std::sin(angle);
  Arc arc = planar(from, center, end, plane,
                   degrees > 0 ? ArcRotation::counterclockwise : ArcRotation::clockwise, 0);
  arc.sweep = std::abs(angle);
  return arc;
}

CircleTurns himc_turns(int turns) {
  if (turns < 0) return {ArcRotation::clockwise, -turns - 1};
  return {ArcRotation::counterclockwise, std::max(turns, 1) - 1};
}

Point point_at(const Arc& arc, double angle) {
  Point p = vec::sum(arc.center, arc.e1, arc.radius * std::cos(angle));
  p = vec::sum(p, arc.e2, arc.radius * std::sin(angle));
  return vec::sum(p, arc.drift, angle / arc.sweep);
}

}  // namespace jounce
