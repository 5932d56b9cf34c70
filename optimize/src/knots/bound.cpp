// SPDX-License-Identifier: Apache-2.0
#include "optimize/src/knots/bound.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>
#include <vector>

#include "jounce/cam/design/design.hpp"
#include "jounce/profiles/curve/extrema.hpp"
#include "jounce/profiles/curve/roots.hpp"

#include "optimize/src/knots/free_quantities.hpp"

// Peak acceleration A. d is the displacement, after a reflection that makes d >= (v0 + v1) L / 2.
// Full acceleration A up to the speed w and full deceleration after it cover the greatest distance:
//     (1)  w = (v0 + v1 + A L) / 2,   d = (v0 + v1) L / 2 + A L^2 / 4 - (v1 - v0)^2 / (4 A)
// (1) gives the least A. With a speed limit V < w, the motion moves at V between them:
//     (2)  A = (2 d' + sqrt(4 d'^2 + (v1 - v0)^2 L^2)) / L^2,   d' = d - (v0 + v1) L / 2
//     (3)  d = V L - ((V - v0)^2 + (V - v1)^2) / (2 A)
//
// Peak jerk, x = 1 - u / L in [0, 1], j the jerk. The values at the ends determine moments of j:
//     (4)  M0 = integral of j     = (a1 - a0) / L
//     (5)  M1 = integral of x j   = (v1 - v0 - a0 L) / L^2
//     (6)  M2 = integral of x^2 j = 2 (d - v0 L - a0 L^2 / 2) / L^3
// so for any polynomial q = q0 + q1 x + q2 x^2 in the moments that are determined
//     (7)  max |j| >= |q0 M0 + q1 M1 + q2 M2| / integral of |q|,
// with equality where j = +-J sign(q) has these moments: the perfect spline, which switches at the roots of q.
// Any q gives a valid bound, so an inexact root can only make the bound lower.
// Both accelerations given, switches at t1 <= t2, r = 1 / J signed:
//     (8)  t2 - t1 = w = (1 - M0 r) / 2,   t2^2 - t1^2 = g = 1/2 - M1 r,
//          t2^3 - t1^3 = (1 - 3 M2 r) / 2,  hence  2 w (1 - 3 M2 r) - 3 g^2 - w^4 = 0
// a0 given, a1 free (q0 = 0), one switch at t:
//     (9)  M1 (2 t^3 - 1) / 3 = M2 (t^2 - 1/2)
// Both free: only M1 - M2 does not depend on a0, and q = x - x^2 keeps its sign, so the cubic has
//     (10) J = 6 |M1 - M2| = 6 |v0 + v1 - 2 d / L| / L^2
//
// Square of acceleration: the cubic solves f'''' = 0, the natural equation for the integral of f''^2:
//     (11) 4 (v0^2 + v0 v1 + v1^2) / L - 12 d (v0 + v1) / L^2 + 12 d^2 / L^3
//
// A place to pass inside an interval, with free velocity and a slave position within bounds. The
// remainder of Taylor's polynomial from an end is at least
//     (12) n2 = |d - v0 L|,   n3 = |d - v0 L - a0 L^2 / 2|,
//          A >= 2 n2 / L^2,   J >= 6 n3 / L^3,   integral of f''^2 >= 3 n2^2 / L^3
// for the nearest of the permitted slave positions. If the master position of the place is free
// within bounds, the bounds are divided into cells. In each cell the least n and the greatest L are
// used, and the bound is the least of all cells.

namespace jounce {
namespace {

using optimize_detail::Freedom;
using optimize_detail::Knot;

constexpr double infinite = std::numeric_limits<double>::infinity();

struct Moments {
  double m0 = 0;
  double m1 = 0;
  double m2 = 0;
};

Moments moments(const KnotInterval& s, double a0, double a1) {
  const double L = s.length;
  return {(a1 - a0) / L, (s.v1 - s.v0 - a0 * L) / (L * L),                  // (4), (5)
          2 * (s.displacement - s.v0 * L - a0 * L * L / 2) / (L * L * L)};  // (6)
}

/// Integral over [0, 1] of |(x - t1)(x - t2)|.
double magnitude_of_quadratic(double t1, double t2) {
  const auto primitive = [&](double x) { return x * (x * (x / 3 - (t1 + t2) / 2) + t1 * t2); };
  const double a = std::clamp(std::min(t1, t2), 0.0, 1.0);
  const double b = std::clamp(std::max(t1, t2), 0.0, 1.0);
  return primitive(a) - (primitive(b) - primitive(a)) + primitive(1) - primitive(b);
}

/// (7) for q = (x - t1)(x - t2).
double bound_with_switches(const Moments& m, double t1, double t2) {
  return std::abs(m.m2 - (t1 + t2) * m.m1 + t1 * t2 * m.m0) / magnitude_of_quadratic(t1, t2);
}

/// The roots of a polynomial in [-radius, radius].
template <std::size_t N>
std::vector<double> real_roots(const std::array<double, N>& c, double radius) {
  Segment f;
  f.degree = static_cast<int>(N) - 1;
  double power = 1;
  for (std::size_t k = 0; k < N; ++k, power *= radius) f.c[k] = c[k] * power;
  // t = radius (2 s - 1)
  Segment shifted = f;
  for (double& x : shifted.c) x = 0;
  for (std::size_t k = N; k-- > 0;) {
    for (std::size_t i = N - 1; i > 0; --i) shifted.c[i] = 2 * shifted.c[i - 1] - shifted.c[i];
    shifted.c[0] = f.c[k] - shifted.c[0];
  }
  std::vector<double> found;
  roots(shifted, 0, found);
  for (double& t : found) t = radius * (2 * t - 1);
  return found;
}

/// Both end accelerations given.
double jerk_with_two_switches(const Moments& m) {
  // (7) with q = 1, x, x^2: simple bounds, which also bracket r.
  const double floor = std::max({std::abs(m.m0), 2 * std::abs(m.m1), 3 * std::abs(m.m2)});
  if (floor == 0) return 0;
  const Moments n{m.m0 / floor, m.m1 / floor, m.m2 / floor};
  // (8) times 16, expanded in r.
  const double a = n.m0;
  const double b = n.m1;
  const double c = 3 * n.m2;
  const std::array<double, 5> quartic{16 - 12 - 1, -16 * (a + c) + 48 * b + 4 * a,
                                      16 * a * c - 48 * b * b - 6 * a * a, 4 * a * a * a,
                                      -a * a * a * a};
  double best = floor;
  for (const double r : real_roots(quartic, 1)) {
    const double w = (1 - a * r) / 2;
    const double g = 0.5 - b * r;
    if (!(w > 0)) continue;
    const double t1 = (g / w - w) / 2;
    const double t2 = (g / w + w) / 2;
    if (std::isfinite(t1) && std::isfinite(t2))
      best = std::max(best, floor * bound_with_switches(n, t1, t2));
  }
  return best;
}

/// a0 given, a1 free: q = x (x - t).
double jerk_with_one_switch(const Moments& m) {
  double best = std::max(2 * std::abs(m.m1), 3 * std::abs(m.m2));
  if (best == 0) return 0;
  const double a = m.m1 / best;
  const double c = m.m2 / best;
  const Moments n{0, a, c};
  const double scale = best;
  for (const double t : real_roots(std::array{c / 2 - a / 3, 0.0, -c, 2 * a / 3}, 1))  // (9)
    if (t > 0) best = std::max(best, scale * bound_with_switches(n, 0, t));
  return best;
}

KnotInterval run_backwards(const KnotInterval& s) {
  KnotInterval back{s.length, s.displacement, s.v1, s.v0, {}, {}};
  if (s.a1) back.a0 = -*s.a1;
  if (s.a0) back.a1 = -*s.a0;
  return back;
}

// ---- the whole cam ------------------------------------------------------------------------------

/// True if master, slave and geo_velocity stay as they are.
bool stays(const Freedom& f) {
  return !f[0] && !f[1] && !f[2];
}

KnotInterval interval_between(const Knot& from, const Freedom& free_from, const Knot& to,
                              const Freedom& free_to) {
  KnotInterval s{to[0] - from[0], to[1] - from[1], from[2], to[2], {}, {}};
  if (!free_from[3]) s.a0 = from[3];
  if (!free_to[3]) s.a1 = to[3];
  return s;
}

double bound_of_interval(const KnotInterval& s, Objective objective, const Limits& limits) {
  switch (objective) {
    case Objective::peak_acceleration:
      return least_peak_acceleration(s, limits.velocity);
    case Objective::peak_jerk:
      return least_peak_jerk(s);
    case Objective::rms_acceleration:
      break;
  }
  return least_square_acceleration(s);
}

/// A place that the cam passes inside an interval: its displacement from the beginning, and its distance after
/// it.
struct Passing {
  Bound displacement;
  Bound after;
};

/// The least |d - v L - a L^2 / 2| for d, and for L > 0, within their bounds.
double least_rest(const Bound& d, double v, double a, const Bound& length) {
  const auto between = [](double x, double y) { return std::pair{std::min(x, y), std::max(x, y)}; };
  const auto [v_low, v_high] = between(v * length.lower, v * length.upper);
  const auto [a_low, a_high] =
      between(a * length.lower * length.lower / 2, a * length.upper * length.upper / 2);
  return std::max({0.0, d.lower - v_high - a_high, v_low + a_low - d.upper});
}

/// (12) from the beginning of an interval to a place with the displacement `d`.
double bound_of_side(const KnotInterval& s, const Bound& d, const Bound& length,
                     Objective objective) {
  const double L = length.upper;
  if (!(L > 0)) return 0;
  if (objective == Objective::peak_jerk)
    return s.a0 ? 6 * least_rest(d, s.v0, *s.a0, length) / (L * L * L) : 0;
  const double n = least_rest(d, s.v0, 0, length);
  return objective == Objective::peak_acceleration ? 2 * n / (L * L) : 3 * n * n / (L * L * L);
}

/// (12) from both sides, over all cells.
double bound_through(const KnotInterval& s, const Passing& place, Objective objective) {
  constexpr int cells = 64;
  const KnotInterval back{s.length, -s.displacement, -s.v1, -s.v0, s.a1, s.a0};
  const double width = (place.after.upper - place.after.lower) / cells;
  double least = infinite;
  for (int i = 0; i < cells; ++i) {
    const Bound cell{place.after.lower + i * width,
                     i + 1 == cells ? place.after.upper : place.after.lower + (i + 1) * width};
    const Bound left{s.length - cell.upper, s.length - cell.lower};
    const double before = bound_of_side(s, place.displacement, cell, objective);
    const Bound behind{place.displacement.lower - s.displacement,
                       place.displacement.upper - s.displacement};
    const double after = bound_of_side(back, behind, left, objective);
    least = std::min(
        least, objective == Objective::rms_acceleration ? before + after : std::max(before, after));
  }
  return least;
}

/// The knots between two others, each with the bounds of its master and slave.
std::vector<Passing> passed(const CamProblem& problem, const std::vector<Knot>& knots,
                            std::size_t from, std::size_t to) {
  std::vector<Passing> all;
  for (std::size_t i = from + 1; i < to; ++i) {
    Bound master{knots[i][0], knots[i][0]};
    Bound slave{knots[i][1], knots[i][1]};
    for (const FreeKnot& each : problem.free) {
      if (each.knot == i && each.master) master = *each.master;
      if (each.knot == i && each.slave) slave = *each.slave;
    }
    const Bound after{std::max(master.lower, knots[from][0]) - knots[from][0],
                      std::min(master.upper, knots[to][0]) - knots[from][0]};
    all.push_back({{slave.lower - knots[from][1], slave.upper - knots[from][1]}, after});
  }
  return all;
}

/// The share of one segment that cannot change in the objective: its peak, or its integral.
double exact_share(const CamDesign& made, std::size_t segment, Objective objective) {
  std::vector<Segment> own;
  for (std::size_t i = 0; i < made.origin.size(); ++i)
    if (made.origin[i] == segment) own.push_back(made.cam.segments()[i]);
  const Cam cam(std::move(own));
  const double value = value_of(objective, cam);
  return objective == Objective::rms_acceleration ? value * value * cam.length() : value;
}

/// True if a law has the acceleration of the knot at its end; other laws determine it themselves.
bool takes_acceleration(Law law) {
  const Ends ends = info(law).ends;
  return ends != Ends::moving_free && !reverses(ends);
}

}  // namespace

double least_peak_acceleration(const KnotInterval& s, std::optional<double> velocity_limit) {
  const double L = s.length;
  const double chord = (s.v0 + s.v1) * L / 2;
  const double sign = s.displacement < chord ? -1 : 1;
  const double v0 = sign * s.v0;
  const double v1 = sign * s.v1;
  const double d = sign * s.displacement;
  const double surplus = d - sign * chord;
  const double free = (2 * surplus + std::hypot(2 * surplus, (v1 - v0) * L)) / (L * L);  // (2)
  if (!velocity_limit || (v0 + v1 + free * L) / 2 <= *velocity_limit) {                  // (1)
    const bool kept = !velocity_limit || std::max(std::abs(v0), std::abs(v1)) <= *velocity_limit;
    return kept ? free : infinite;
  }
  const double V = *velocity_limit;
  if (std::max(std::abs(v0), std::abs(v1)) > V || V * L <= d) return infinite;
  return ((V - v0) * (V - v0) + (V - v1) * (V - v1)) / (2 * (V * L - d));  // (3)
}

double least_peak_jerk(const KnotInterval& s) {
  if (s.a0 && s.a1) return jerk_with_two_switches(moments(s, *s.a0, *s.a1));
  if (s.a0) return jerk_with_one_switch(moments(s, *s.a0, 0));
  if (s.a1) return least_peak_jerk(run_backwards(s));
  return 6 * std::abs(s.v0 + s.v1 - 2 * s.displacement / s.length) / (s.length * s.length);  // (10)
}

double least_square_acceleration(const KnotInterval& s) {
  const double L = s.length;
  const double d = s.displacement;
  return 4 * (s.v0 * s.v0 + s.v0 * s.v1 + s.v1 * s.v1) / L - 12 * d * (s.v0 + s.v1) / (L * L) +
         12 * d * d / (L * L * L);  // (11)
}

double lower_bound(const CamProblem& problem, Objective objective) {
  const auto knots = optimize_detail::knots_of(problem.cam);
  const auto free = optimize_detail::freedom(problem);
  const CamDesign made = design(problem.cam);
  const auto& segments = problem.cam.segments;
  const bool rms = objective == Objective::rms_acceleration;
  double bound = 0;
  const auto combine = [&](double share) { bound = rms ? bound + share : std::max(bound, share); };
  std::optional<std::size_t> from;
  for (std::size_t i = 0; i < knots.size(); ++i) {
    if (!stays(free[i])) continue;
    if (from && from == i - 1 && !free[*from][3] && !free[i][3])
      combine(exact_share(made, *from, objective));
    else if (from) {
      KnotInterval s = interval_between(knots[*from], free[*from], knots[i], free[i]);
      if (!takes_acceleration(segments[*from].law)) s.a0.reset();
      if (!takes_acceleration(segments[i - 1].law)) s.a1.reset();
      double share = bound_of_interval(s, objective, problem.limits);
      for (const Passing& place : passed(problem, knots, *from, i))
        share = std::max(share, bound_through(s, place, objective));
      combine(share);
    }
    from = i;
  }
  return rms ? std::sqrt(bound / (knots.back()[0] - knots.front()[0])) : bound;
}

}  // namespace jounce
