// SPDX-License-Identifier: Apache-2.0
#include "jounce/cam/disc/plate_motion.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <string>

#include "jounce/profiles/detail/six_digits.hpp"
#include "jounce/profiles/error.hpp"

#include "cam/src/disc/pitch.hpp"

// The roller touches a piece of the profile where the distance of its center from the piece is the
// radius r of the roller. The places of such centers are:
//
//   (1)  for a vertex: the circle of radius r around it
//   (2)  for a line: the two parallel lines at the distance r, beside the line
//   (3)  for an arc of radius R: the circles R + r and |R - r| around its center, in the sector of
//        the arc (for r > R, |R - r| in the opposite sector)
//
// All these places are within the distance r of the profile. Hence the farthest of their
// intersections with the way of the roller's center is the position at which a roller from outside
// stops. In the fixed frame, the way is the line x = e of a slide, or the circle of an arm.
namespace jounce {
namespace {

using Complex = std::complex<double>;

double dot(Complex a, Complex b) {
  return a.real() * b.real() + a.imag() * b.imag();
}

/// The line x = offset. Its position is y.
struct Slide {
  double offset;

  [[nodiscard]] double position(Complex p) const { return p.imag(); }
  template <class Visit>
  void on_circle(Complex center, double radius, const Visit& visit) const {
    const double across = offset - center.real();
    if (std::abs(across) > radius) return;
    const double along = std::sqrt((radius - across) * (radius + across));
    for (const double sign : {1.0, -1.0}) visit(Complex(offset, center.imag() + sign * along));
  }
  template <class Visit>
  void on_line(Complex from, Complex way, const Visit& visit) const {
    if (way.real() == 0) return;  // its vertices are the ends of the contact
    visit(Complex(offset, from.imag() + (offset - from.real()) / way.real() * way.imag()));
  }
};

/// The circle of the arm's end around the pivot (c, 0). Its position is the angle of the arm.
struct Arm {
  double length, center_distance;

  [[nodiscard]] double position(Complex p) const { return -std::arg(center_distance - p); }
  template <class Visit>
  void on_circle(Complex center, double radius, const Visit& visit) const {
    const Complex between = center - center_distance;
    const double d = std::abs(between);
    if (d == 0 || d > length + radius || d < std::abs(length - radius)) return;
    const double along = (d + (length - radius) * (length + radius) / d) / 2;
    const double across = std::sqrt(std::max(0.0, (length - along) * (length + along)));
    for (const double sign : {1.0, -1.0})
      visit(center_distance + between / d * Complex(along, sign * across));
  }
  template <class Visit>
  void on_line(Complex from, Complex way, const Visit& visit) const {
    const Complex unit = way / std::abs(way);
    const Complex toward = (center_distance - from) * std::conj(unit);
    const double height = toward.imag();
    if (std::abs(height) > length) return;
    const double along = std::sqrt((length - height) * (length + height));
    for (const double sign : {1.0, -1.0}) visit(from + unit * (toward.real() + sign * along));
  }
};

/// A piece of the profile, in the frame of the cam.
struct Piece {
  Complex from, to;
  double bulge = 0;
  Complex center = {};  ///< center of an arc
  double radius = 0;
  double least = 0;     ///< cosine of half of the arc's angle
  Complex middle = {};  ///< direction from the center to the middle of the arc
};

Piece piece_of(const Vertex& a, const Vertex& b) {
  Piece p{{a.x, a.y}, {b.x, b.y}, a.bulge};
  if (p.bulge == 0) return p;
  const Complex chord = p.to - p.from;
  const Complex top = p.from + chord * Complex(0.5, -0.5 * p.bulge);
  const Complex normal = chord * Complex(0, p.bulge > 0 ? -1 : 1) / std::abs(chord);
  p.radius = std::abs(chord) * (1 + p.bulge * p.bulge) / (4 * std::abs(p.bulge));
  p.center = top - p.radius * normal;
  p.middle = normal;
  p.least = std::cos(2 * std::atan(std::abs(p.bulge)));
  return p;
}

/// The farthest position of the roller's center on its way; NaN if it meets no piece. `turn`: from
/// the frame of the cam to the fixed frame.
template <class Way>
double farthest(const std::vector<Piece>& pieces, Complex turn, double roller, const Way& way) {
  double most = -std::numeric_limits<double>::infinity();
  const auto take = [&](Complex p) {
    const double at = way.position(p);
    if (at > most) most = at;
  };
  for (const Piece& piece : pieces) {
    const Complex from = turn * piece.from, chord = turn * (piece.to - piece.from);
    way.on_circle(from, roller, take);
    if (piece.bulge == 0) {
      const double length = std::abs(chord);
      const Complex normal = chord / length * Complex(0, roller);
      const auto beside = [&](Complex p) {
        const double along = dot(p - from, chord);
        if (along >= 0 && along <= length * length) take(p);
      };
      way.on_line(from + normal, chord, beside);
      if (roller > 0) way.on_line(from - normal, chord, beside);
      continue;
    }
    const Complex center = turn * piece.center, middle = turn * piece.middle;
    for (const double radius : {piece.radius + roller, piece.radius - roller})
      way.on_circle(center, std::abs(radius), [&](Complex p) {
        // Cosine of the angle between the contact and the middle of the arc.
        const double along = dot(p - center, middle);
        if ((radius < 0 ? -along : along) >= piece.least * std::abs(radius)) take(p);
      });
  }
  return most;
}

}  // namespace

PlateMotion plate_motion(const Contour& profile, const DiscSpec& spec,
                         std::span<const double> masters) {
  if (profile.size() < 2)
    throw InputError("profile", std::to_string(profile.size()) + " vertices", "must be at least 2");
  std::vector<Piece> pieces;
  for (std::size_t i = 0; i < profile.size(); ++i) {
    const Vertex &a = profile[i], &b = profile[(i + 1) % profile.size()];
    if (a.x != b.x || a.y != b.y) pieces.push_back(piece_of(a, b));
  }
  DiscSpec based = spec;
  if (spec.base_radius == 0) based.base_radius = 1;  // follows below
  cam_detail::require_lengths(based);
  const bool slides = spec.follower == Follower::translating;
  std::vector<double> positions;
  double least = std::numeric_limits<double>::infinity();
  for (const double master : masters) {
    const Complex turn = std::polar(1.0, cam_detail::sigma(spec) * spec.angle * master);
    const double position = slides ? farthest(pieces, turn, spec.roller_radius, Slide{spec.offset})
                                   : farthest(pieces, turn, spec.roller_radius,
                                              Arm{spec.arm_length, spec.center_distance});
    if (!std::isfinite(position))
      throw InputError("profile", "",
                       "is not met by the follower at master " + six_digits(master) +
                           ": check the place of the center and the lengths of the follower");
    least = std::min(least, position);
    positions.push_back(position);
  }
  if (spec.base_radius == 0) {
    const Complex center = slides
                               ? Complex(spec.offset, least)
                               : spec.center_distance - spec.arm_length * std::polar(1.0, -least);
    based.base_radius = std::abs(center) - spec.roller_radius;
  }
  if (spec.base_radius == 0 && !(based.base_radius > 0))
    throw InputError("roller_radius", spec.roller_radius,
                     "leaves no base circle in this plate: give a smaller radius, or correct the "
                     "place of the center");
  require_positive("base_radius", based.base_radius);
  const double start = cam_detail::start_of(based, 0);
  PlateMotion motion{std::move(positions), based.base_radius};
  const double unit = slides ? 1 : cam_detail::arm_angle(spec);
  for (double& each : motion.slave) each = (each - start) / unit;
  return motion;
}

}  // namespace jounce
