// SPDX-License-Identifier: Apache-2.0
#include "jounce/cam/laws/law.hpp"

#include <cassert>
#include <cmath>
#include <numbers>
#include <string>

#include "jounce/profiles/curve/between.hpp"
#include "jounce/profiles/curve/curve.hpp"
#include "jounce/profiles/detail/six_digits.hpp"
#include "jounce/profiles/detail/tolerances.hpp"
#include "jounce/profiles/error.hpp"

#include "cam/src/laws/added.hpp"

// Every law uses one of three kinds of rise, and one method for end velocities.
//
// **Ramps.** In a ramp, the acceleration rises as a quarter sine, is constant, and falls as a
// quarter cosine. From rest over the length L it ends at the velocity v and the position y, both in
// proportion to its peak. A rise consists of a ramp up over L1, a straight part of length s, and a
// ramp down over L2, which is the point reflection of a ramp up. The velocity V between the ramps
// follows from the stroke h (1 for a rise) and from the velocities v0, v1 at the ends, onto which the ramps are put:
//
//     (1)  V (y1 + s + y2) = h - v0 (L1 - y1) - v1 (L2 - y2),   y = L m,
//          m = position / (L velocity) of a ramp from rest
//
// The laws that enter and leave with ramps (G-G, G-U) are these for (h, v0, v1) = (0, 1, 0) and (0, 0, 1).
//
// **Polynomials** have degree 2n - 1; their derivatives up to the (n-1)-th are given at both ends.
// The shape whose k-th derivative at 0 is 1, and whose other given derivatives are 0, is (Hermite;
// from the binomial series of (1 - z)^-n)
//
//     (2)  H_k(z) = z^k / k! (1 - z)^n sum over i < n - k of C(n - 1 + i, i) z^i
//
// and at the other end (-1)^k H_k(1 - z). All coefficients times k! are integers.
//
// **Inflection.** A rise f that is point-symmetric about its middle gets its inflection at lambda
// by
//
//     (3)  F(z) = 2 lambda f(z / 2 lambda)                              for z <= lambda
//     (4)  F(z) = 1 - 2 (1 - lambda) (1 - f(1 - (1 - z) / 2 (1 - lambda)))  above:
//
// The velocity peak stays, and both parts meet there with acceleration 0.
//
// **End velocities.** Let R(z) be the integral of the rise F from 0, which is a smooth ramp of
// velocity. Then
//
//     (5)  enter = z - R - (1 - R(1)) F:   value 0 at both ends, slope 1 at 0 and 0 at 1
//     (6)  leave = R - R(1) F:             value 0 at both ends, slope 0 at 0 and 1 at 1
//
// have no acceleration at the ends if F has none. So every such law joins any two velocities. With
// equal velocities it is a rise on a slope, such as the recovery of a rotary knife.

namespace jounce {
namespace {

using cam_detail::added;

using profiles_detail::rounded_sum;

constexpr double pi = std::numbers::pi;

struct Ramp {
  double rise = 0, constant = 0, fall = 0;  // shares of the ramp's length
};

/// sin over [from, to] rad, as a segment of the given length.
Segment sine_piece(double length, double from, double to) {
  Segment f;
  f.length = length;
  f.sines = 1;
  f.sine[0] = {1, to - from, from};
  return f;
}

/// A ramp from rest over `length`, with a peak acceleration of 1, as a curve of the position.
Cam ramp_up(const Ramp& ramp, double length) {
  std::vector<Segment> acceleration;
  if (ramp.rise > 0) acceleration.push_back(sine_piece(ramp.rise * length, 0, pi / 2));
  if (ramp.constant > 0) acceleration.push_back(line(ramp.constant * length, 1, 1));
  if (ramp.fall > 0) acceleration.push_back(sine_piece(ramp.fall * length, pi / 2, pi));
  return integral(integral(Cam(std::move(acceleration))));
}

/// The stroke of a law, and the velocities at its ends.
struct RampEnds {
  double stroke = 1, from = 0, to = 0;
};

/// The curve of (1). `down` is described from its end backwards.
std::vector<Segment> ramped(const Ramp& up, double up_length, double straight, const Ramp& down,
                            double down_length, const RampEnds& ends = {}) {
  const Cam a = ramp_up(up, up_length);
  const Cam b = ramp_up(down, down_length);
  const Jet a_end = a.jet(a.end(), Side::left);
  const Jet b_end = b.jet(b.end(), Side::left);
  const double y1 = a_end[0] / a_end[1];
  const double y2 = b_end[0] / b_end[1];
  const double rest = ends.stroke - ends.from * (up_length - y1) - ends.to * (down_length - y2);
  const double velocity = rest / (y1 + straight + y2);  // (1)
  const auto sloped = [](const Cam& ramp, double slope, double from) {
    return slope == 0 ? ramp
                      : sum(ramp, Cam({line(ramp.length(), from, from + slope * ramp.length())}));
  };
  const Cam first = sloped(scaled(a, (velocity - ends.from) / a_end[1]), ends.from, 0);
  const Cam second =
      sloped(shifted(scaled(reversed(b), -(velocity - ends.to) / b_end[1]), 0, ends.stroke),
             ends.to, -ends.to * down_length);
  std::vector<Segment> rise(first.segments().begin(), first.segments().end());
  if (straight > 0)
    rise.push_back(line(straight,
                        (velocity - ends.from) / a_end[1] * a_end[0] + ends.from * up_length,
                        value(second.segments()[0], 0)));
  rise.insert(rise.end(), second.segments().begin(), second.segments().end());
  return rise;
}

double binomial(int n, int k) {
  double b = 1;
  for (int i = 1; i <= k; ++i) b = b * (n - k + i) / i;
  return b;
}

/// H_k of equation (2).
Segment hermite_shape(int n, int k) {
  Segment f;
  f.degree = 2 * n - 1;
  const double scale = k == 3 ? 1. / 6 : k == 2 ? 0.5 : 1;  // 1 / k!
  for (int i = 0; i < n - k; ++i)
    for (int m = 0; m <= n; ++m)
      f.c[static_cast<std::size_t>(k + i + m)] +=
          scale * binomial(n - 1 + i, i) * binomial(n, m) * (m % 2 == 0 ? 1 : -1);
  return f;
}

/// The polynomial law of degree 2n - 1, with the contributions of its end velocities,
/// accelerations and, from degree 7 on, jerks.
LawPiece hermite(int n, bool bends) {
  const Segment none;
  const auto mirrored = [](const Segment& f, double sign) { return scaled(reversed(f), sign); };
  LawPiece piece{mirrored(hermite_shape(n, 0), 1), hermite_shape(n, 1),
                 mirrored(hermite_shape(n, 1), -1), none, none};
  if (bends) {
    piece.bend_in = hermite_shape(n, 2);
    piece.bend_out = mirrored(piece.bend_in, 1);
  }
  if (bends && n > 3) {
    piece.jerk_in = hermite_shape(n, 3);
    piece.jerk_out = mirrored(piece.jerk_in, -1);
  }
  return piece;
}

/// slope z + sum of the amplitudes times sin(2 pi k z).
Segment harmonics(std::initializer_list<std::pair<int, double>> terms) {
  Segment f = line(1, 0, 1);
  for (const auto& [k, amplitude] : terms)
    f.sine[static_cast<std::size_t>(f.sines++)] = {amplitude, 2 * pi * k, 0};
  return f;
}

Segment simple_sine() {
  Segment f;
  f.c[0] = 0.5;
  f.sines = 1;
  f.sine[0] = {0.5, pi, -pi / 2};
  return f;
}

/// f'' = a1 sin 2 pi z + a2 sin 4 pi z + a3 sin 6 pi z. The stroke of 1 determines the third amplitude:
/// a1 / 2 + a2 / 4 + a3 / 6 = pi. Source: MechDesigner, motion-law Triple-Harmonic.
Segment triple_harmonic(const std::optional<std::array<double, 2>>& given) {
  const auto& [a1, a2] = given.value_or(std::array{9 * pi / 4, 0.});
  const double a3 = 6 * (pi - a1 / 2 - a2 / 4);
  return harmonics(
      {{1, -a1 / (4 * pi * pi)}, {2, -a2 / (16 * pi * pi)}, {3, -a3 / (36 * pi * pi)}});
}

/// ((1 - cos pi z) - (1 - cos 2 pi z) / 4) / 2
Segment double_harmonic() {
  Segment f;
  f.c[0] = 3. / 8;
  f.sines = 2;
  f.sine[0] = {0.5, pi, -pi / 2};
  f.sine[1] = {1. / 8, 2 * pi, pi / 2};
  return f;
}

/// R. Norton, Cam Design and Manufacturing Handbook: the published five decimals, which sum to 1.
Segment eighth_degree() {
  Segment f;
  f.degree = 8;
  f.c = {0, 0, 0, 6.09755, 0, -20.78040, 26.73155, -13.60965, 2.56095};
  return f;
}

/// f''' = 32, -32, 32 with switches at 1/4 and 3/4.
std::vector<Segment> perfect_spline() {
  const Cam rise = integral(
      integral(integral(Cam({line(0.25, 32, 32), line(0.5, -32, -32), line(0.25, 32, 32)}))));
  return {rise.segments().begin(), rise.segments().end()};
}

/// The ramps of a law whose inflection lies between them; `down` is described from its end.
struct Ramps {
  Ramp up, down;
};

std::optional<Ramps> ramps(Law law) {
  constexpr Ramp sine{0.25, 0, 0.75};
  if (law == Law::modified_sine_gg) return Ramps{sine, sine};
  if (law == Law::harmonic_combination || law == Law::harmonic_combination_gu)
    return Ramps{sine, {0, 0, 1}};
  if (law == Law::modified_trapezoid_ru) return Ramps{{0.25, 0.5, 0.25}, {0, 0.75, 0.25}};
  return std::nullopt;
}

std::vector<Segment> ramped(const Ramps& shape, double lambda, const RampEnds& ends = {}) {
  return ramped(shape.up, lambda, 0, shape.down, 1 - lambda, ends);
}

/// Equations (3) and (4).
std::vector<Segment> inflected(const std::vector<Segment>& rise, double lambda) {
  if (lambda == 0.5) return rise;
  const Cam whole(rise);
  const Cam below = between(whole, 0, 0.5);
  const Cam above = between(whole, 0.5, whole.end());
  std::vector<Segment> moved;
  const auto add = [&](const Cam& half, double factor, double offset) {
    for (Segment f : half.segments()) {
      f = scaled(f, factor, offset);
      f.length *= factor;
      moved.push_back(f);
    }
  };
  add(below, 2 * lambda, 0);                     // (3)
  add(above, 2 * (1 - lambda), 2 * lambda - 1);  // (4)
  return moved;
}

[[noreturn]] void refuse(const char* key, const std::string& value, Law law) {
  throw InputError(key, value,
                   std::string("does not apply to the law `") + name(law) + "`: leave it out");
}

std::vector<Segment> rise(Law law, const LawForm& form) {
  const double straight = form.straight.value_or(0.5);
  const double lambda = form.inflection.value_or(0.5);
  switch (law) {
    case Law::line:
    case Law::dwell:
      return {line(1, 0, 1)};
    case Law::cubic:
      return {hermite(2, false).rise};
    case Law::quintic:
    case Law::poly345:
      return {hermite(3, false).rise};
    case Law::septic:
    case Law::poly4567:
      return {hermite(4, false).rise};
    case Law::nonic:
    case Law::poly56789:
      return {hermite(5, false).rise};
    case Law::parabola:
      return scca(0, 1, 0);
    case Law::simple_sine:
      return {simple_sine()};
    case Law::inclined_sine:
      return {harmonics({{1, -1 / (2 * pi)}})};
    case Law::modified_sine:
      return scca(0.25, 0, 0.75);
    case Law::modified_trapezoid:
      return scca(0.25, 0.5, 0.25);
    case Law::modified_constant_velocity:
      return scca(0.25, 0, 0.75, straight);
    case Law::sine_straight:
      return scca(0, 0, 1, straight);
    case Law::scca: {
      const auto& [b, c, d] = *form.shares;
      return scca(b, c, d, form.straight.value_or(0));
    }
    case Law::gutman13:
      return {harmonics({{1, -15 / (32 * pi)}, {3, -1 / (96 * pi)}})};
    case Law::freudenstein13:
      return {harmonics({{1, -27. / 28 / (2 * pi)}, {3, -1. / 84 / (2 * pi)}})};
    case Law::freudenstein135: {
      constexpr double m = 1125. / 1192 / (2 * pi);
      return {harmonics({{1, -m}, {3, -m / 54}, {5, -m / 1250}})};
    }
    case Law::triple_harmonic:
      return {triple_harmonic(form.harmonics)};
    case Law::minimum_peak_jerk:
      return perfect_spline();
    case Law::modified_sine_gg:
    case Law::harmonic_combination:
    case Law::harmonic_combination_gu:
    case Law::modified_trapezoid_ru:
      return ramped(*ramps(law), lambda);
    case Law::double_harmonic:
      return {double_harmonic()};
    case Law::eighth_degree:
      return {eighth_degree()};
    case Law::polynomial:
    case Law::cubic_spline:
    case Law::quintic_spline:
    case Law::hermite:
    case Law::b_spline:
      break;
  }
  assert(false && "a law through points has no shape of its own");
  return {};
}

/// The n of a polynomial law whose end values enter by (2); 0 for all other laws.
int hermite_order(Law law) {
  switch (law) {
    case Law::cubic:
      return 2;
    case Law::quintic:
    case Law::poly345:
      return 3;
    case Law::septic:
    case Law::poly4567:
      return 4;
    case Law::nonic:
    case Law::poly56789:
      return 5;
    default:
      return 0;
  }
}

/// Equations (5) and (6).
std::vector<LawPiece> with_end_velocities(const std::vector<Segment>& rise) {
  const Cam ramp = integral(Cam(rise));
  const double whole = ramp.jet(ramp.end(), Side::left)[0];
  std::vector<LawPiece> all;
  for (std::size_t i = 0; i < rise.size(); ++i) {
    const Segment& f = rise[i];
    const Segment& r = ramp.segments()[i];
    Segment none;
    none.length = f.length;
    const double z0 = ramp.breaks()[i];
    const Segment z = line(f.length, z0, z0 + f.length);
    all.push_back({f, added(z, added(scaled(r, -1), scaled(f, whole - 1))),
                   added(r, scaled(f, -whole)), none, none});
  }
  return all;
}

/// The pieces of a law that enters and leaves with ramps.
std::vector<LawPiece> with_ramps(const Ramps& shape, double lambda) {
  const auto rise = ramped(shape, lambda);
  const auto enter = ramped(shape, lambda, {0, 1, 0});
  const auto leave = ramped(shape, lambda, {0, 0, 1});
  std::vector<LawPiece> all;
  for (std::size_t i = 0; i < rise.size(); ++i) {
    Segment none;
    none.length = rise[i].length;
    all.push_back({rise[i], enter[i], leave[i], none, none});
  }
  return all;
}

}  // namespace

void require_valid(Law law, const LawForm& form) {
  if (form.inflection) {
    if (!info(law).inflection) refuse("inflection", number(*form.inflection), law);
    if (!(*form.inflection > 0 && *form.inflection < 1))
      throw InputError("inflection", *form.inflection,
                       "must lie inside the segment: above 0 and below 1");
  }
  if (form.straight) {
    if (law != Law::scca && law != Law::modified_constant_velocity && law != Law::sine_straight)
      refuse("straight", number(*form.straight), law);
    if (!(*form.straight >= 0 && *form.straight < 1))
      throw InputError("straight", *form.straight,
                       "must be a share of the segment: at least 0 and below 1");
  }
  if (form.harmonics) {
    if (law != Law::triple_harmonic)
      refuse("harmonics", number((*form.harmonics)[0]) + ", ...", law);
    for (const double amplitude : *form.harmonics) require_finite("harmonics", amplitude);
  }
  if (form.shares && law != Law::scca) refuse("shares", number((*form.shares)[0]) + ", ...", law);
  if (!form.shares && law == Law::scca)
    throw InputError("shares", "",
                     "is missing: the law `scca` needs shares = [sine, constant, cosine]");
}

std::vector<Segment> scca(double b, double c, double d, double straight) {
  require_not_negative("shares[1]", b);
  require_not_negative("shares[2]", c);
  require_not_negative("shares[3]", d);
  require_not_negative("straight", straight);
  if (!(straight < 1))
    throw InputError("straight", straight, "must be less than 1: no share is left for the ramps");
  if (std::abs(b + c + d - 1) > rounded_sum)
    throw InputError("shares", six_digits(b) + " + " + six_digits(c) + " + " + six_digits(d),
                     "must add up to 1, not " + six_digits(b + c + d));
  const double half = (1 - straight) / 2;
  return ramped({b, c, d}, half, straight, {b, c, d}, half);
}

std::vector<Segment> normalized(Law law, const LawForm& form) {
  require_valid(law, form);
  const auto own = rise(law, form);
  return form.inflection && !ramps(law) ? inflected(own, *form.inflection) : own;
}

std::vector<LawPiece> pieces(Law law, const LawForm& form) {
  const auto shape = normalized(law, form);
  if (const int n = hermite_order(law); n > 0 && !form.inflection)
    return {hermite(n, info(law).ends == Ends::given)};
  if (law == Law::modified_sine_gg || law == Law::harmonic_combination_gu)
    return with_ramps(*ramps(law), form.inflection.value_or(0.5));
  if (info(law).ends == Ends::moving || info(law).ends == Ends::moving_free)
    return with_end_velocities(shape);
  std::vector<LawPiece> all;
  for (const Segment& f : shape) {
    Segment none;
    none.length = f.length;
    all.push_back({f, none, none, none, none});
  }
  return all;
}

namespace {

/// The end of a ramp of length 1 and peak 1: its velocity k, and its position divided by the
/// velocity, m.
struct RampEnd {
  explicit RampEnd(const Ramp& ramp) {
    const Cam up = ramp_up(ramp, 1);
    const Jet end = up.jet(up.end(), Side::left);
    k = end[1];
    m = end[0] / end[1];
  }
  double k = 0, m = 0;
};

}  // namespace

// The deceleration is D = V / (x k2), with V of (1) and the ramps over lambda and x = 1 - lambda. With
// c = v0 (1 - m1):
//
//     (7)  D k2 (m2 - m1) x^2 + (D k2 m1 - c) x - (1 - c) = 0,   least at x = 1: D = 1 / (k2 m2)
double inflection_for(Law law, double deceleration, double velocity) {
  assert(deceleration > least_deceleration(law) && velocity < greatest_velocity(law));
  const Ramps shape = *ramps(law);
  const RampEnd up(shape.up);
  const RampEnd down(shape.down);
  const double c = velocity * (1 - up.m);
  const double p = deceleration * down.k * up.m - c;
  const double q = deceleration * down.k * (down.m - up.m);
  // Equation (7), the root without cancellation
  return 1 - 2 * (1 - c) / (p + std::sqrt(p * p + 4 * q * (1 - c)));
}

double least_deceleration(Law law) {
  const RampEnd down(ramps(law)->down);
  return 1 / (down.k * down.m);
}

double greatest_velocity(Law law) {
  return 1 / (1 - RampEnd(ramps(law)->up).m);
}

}  // namespace jounce
