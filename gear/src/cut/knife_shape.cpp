// SPDX-License-Identifier: Apache-2.0
#include "gear/src/cut/knife_shape.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "jounce/profiles/curve/curve.hpp"
#include "jounce/profiles/curve/extrema.hpp"
#include "jounce/profiles/detail/hermite.hpp"
#include "jounce/profiles/detail/tolerances.hpp"

// **The recovery** over the length b, with z = u / b. It begins and ends at the slope g, with the
// accelerations A at its start and -A at its end, and the jerk J at both:
//
//     (1)  y = start + g b z + (h - g b) f(z) + B(z)
//     (2)  B = w^2 (1 - 2 z) (c0 + c1 w),   w = z (1 - z)
//
// f is a symmetric rise from 0 to 1 at rest, so slopes and stroke are correct without B. B is odd
// about the middle; its value and slope are zero at both ends. B'' is 2 c0 at 0 and -2 c0 at 1, and
// B''' is 6 (c1 - 4 c0) at both ends, so
//
//     (3)  c0 = A b^2 / 2,   c1 = 0, or for an f without jerk at its ends  c1 = J b^3 / 6 + 4 c0
//
// With f = 3-4-5, y is the quintic through all given values; with 4-5-6-7 it is the polynomial of
// degree 7. If A = 0, y is h (rho z + (1 - rho) f) with rho = g b / h.
//
// **In its middle** w = 1/4 and w' = 0, and the slope is least or greatest (f' peaks there, and B'
// = (2 w - 10 w^2) c0 + (3 w^2 - 14 w^3) c1 is least):
//
//     (4)  y' = g + (h / b - g) Cv - (c0 / 8 + c1 / 32) / b
//
// This slope is 0, with acceleration 0, so that the knife may stand there for any time, for the b
// that solves
//
//     (5)  J b^3 / 192 + A b^2 / 8 + g (Cv - 1) b - h Cv = 0    (c1 = 0:  A b^2 / 16, no J)
//
// The left side grows and is convex for b > 0, so it has one root. Newton's method approaches the
// root from that of the linear part, which is the result for surface matching: b = Cv / (Cv - 1) h
// / g.
//
// **asin** in the sync zone: y = asin(q). From (1 - q^2) y'' = q y', its Taylor series about q0 is
//
//     (6)  (1 - q0^2) (k + 2) (k + 1) a[k+2] = q0 (k + 1) (2 k + 1) a[k+1] + k^2 a[k]
//
// Nothing cancels for q0 >= 0. All derivatives of asin grow there, so the series at the far end of
// a piece bounds those of the whole piece (fitted.hpp: certified by the twelfth).

namespace jounce::gear_detail {
namespace {

using profiles_detail::rounded_sum;

profiles_detail::Majorant asin_series(double q) {
  profiles_detail::Majorant a{std::asin(q), 1 / std::sqrt((1 - q) * (1 + q))};
  for (std::size_t k = 0; k + 2 < a.size(); ++k) {
    const auto n = static_cast<double>(k);
    a[k + 2] = (q * (n + 1) * (2 * n + 1) * a[k + 1] + n * n * a[k]) /
               ((1 - q) * (1 + q) * (n + 2) * (n + 1));  // (6)
  }
  return a;
}

/// asin over [from, to], 0 <= from < to < 1, for profiles_detail::fit(). [0, 1] corresponds to
/// `scale` m of web.
struct AsinPiece {
  double from;
  double to;
  double scale;

  [[nodiscard]] double length() const { return (to - from) * scale; }
  [[nodiscard]] profiles_detail::EndSeries end(double s) const {
    const profiles_detail::Majorant a = asin_series(s == 0 ? from : to);
    profiles_detail::EndSeries series{};
    double power = 1;
    for (std::size_t k = 0; k < series.size(); ++k, power *= to - from) series[k] = a[k] * power;
    return series;
  }
  [[nodiscard]] double twelfth() const { return asin_series(to).back() * std::pow(to - from, 12); }
  [[nodiscard]] std::pair<AsinPiece, AsinPiece> halves() const {
    const double middle = (from + to) / 2;
    return {{from, middle, scale}, {middle, to, scale}};
  }
};

/// True if the rise starts without jerk, to rounding of its greatest jerk.
bool starts_without_jerk(const std::vector<Segment>& rise) {
  const double most = std::abs(extrema(Cam(rise), 3).peak().value);
  return std::abs(evaluate(rise.front(), 0)[3]) <= rounded_sum * most;
}

}  // namespace

std::vector<Segment> KnifeZone::entering(double pitch) const {
  std::vector<Segment> mirrored;
  for (auto piece = leaving.rbegin(); piece != leaving.rend(); ++piece)
    mirrored.push_back(scaled(reversed(*piece), -1, pitch));
  return mirrored;
}

KnifeZone knife_zone(const KnifeSync& sync, bool horizontal, double tolerance) {
  if (!horizontal) return {{line(sync.length, 0, sync.angle)}, 0};
  KnifeZone zone;
  Jet error{};
  const double s = std::sin(sync.angle);
  profiles_detail::fit(AsinPiece{0, s, sync.length / s}, tolerance, zone.leaving, error);
  zone.strays = error[0];
  return zone;
}

KnifeShape::KnifeShape(std::vector<Segment> rise, const KnifeSync& sync, double travel)
    : rise_(std::move(rise)),
      sync_(sync),
      travel_(travel),
      cv_(extrema(Cam(rise_), 1).max.value),
      jerk_taken_(starts_without_jerk(rise_)) {
  double z = 0;
  for (const Segment& piece : rise_) from_.push_back(std::exchange(z, z + piece.length));
  from_.push_back(1);
}

std::pair<double, double> KnifeShape::bend(double b) const {
  const double c0 = sync_.acceleration * b * b / 2;
  return {c0, jerk_taken_ ? sync_.jerk * b * b * b / 6 + 4 * c0 : 0};  // (3)
}

Segment KnifeShape::piece(std::size_t i, double b, double start) const {
  const auto [c0, c1] = bend(b);
  const double straight = sync_.velocity * b;
  Segment rest;  // equation (1) without f
  rest.length = b;
  rest.degree = c1 != 0 ? 7 : c0 != 0 ? 5 : 1;
  rest.c = {start, straight, c0, -4 * c0 + c1, 5 * c0 - 5 * c1, -2 * c0 + 9 * c1, -7 * c1, 2 * c1};
  const Segment own = part(rest, from_[i], from_[i + 1]);
  Segment f = scaled(rise_[i], travel_ - straight);
  f.length = own.length;
  return *sum(own, f);  // fits: f has one kind of sines, the rest none
}

std::vector<Segment> KnifeShape::recovery(double b, double start) const {
  std::vector<Segment> all;
  for (std::size_t i = 0; i < pieces(); ++i) all.push_back(piece(i, b, start));
  return all;
}

double KnifeShape::middle_velocity(double b) const {
  const auto [c0, c1] = bend(b);
  const double g = sync_.velocity;
  return g + (travel_ / b - g) * cv_ - (c0 / 8 + c1 / 32) / b;  // (4)
}

double KnifeShape::longest() const {
  const double cubic = jerk_taken_ ? sync_.jerk / 192 : 0;  // (5)
  const double square = sync_.acceleration / (jerk_taken_ ? 8 : 16);
  const double linear = sync_.velocity * (cv_ - 1);
  double b = travel_ * cv_ / linear;
  for (int i = 0; i < 100; ++i) {
    const double excess = ((cubic * b + square) * b + linear) * b - travel_ * cv_;
    const double next = b - excess / ((3 * cubic * b + 2 * square) * b + linear);
    if (!(next < b)) break;
    b = next;
  }
  return b;
}

}  // namespace jounce::gear_detail
