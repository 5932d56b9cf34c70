// SPDX-License-Identifier: Apache-2.0
#include "jounce/profiles/moves/fourth_order.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "jounce/profiles/detail/six_digits.hpp"
#include "jounce/profiles/error.hpp"

#include "profiles/src/moves/duration.hpp"

// The move is antisymmetric in time, so its first half determines it: from rest to the peak velocity v
// in the middle, where a = 0 and the jerk is -m. Its jounce is
//
//   +s for b, 0 for c, -s for b     the acceleration rises to p,    p = s b (b + c)
//   0 for d                         stays there                     (only at the limit)
//   -s for b', 0 for c', +s for b"  and falls to zero               b" = q b', 0 <= q <= 1
//
//   (1)  p = s b' (k b' + c'),  k = 1 - (1 - q)^2 / 2,  m = s b' (1 - q)
//
// with b = min(j/s, sqrt(p/s)) and b' = min(j/s, sqrt(p/(k s))): the jerk limit is reached or not.
// There are three cases:
//
//   (2)  The velocity limit is not reached: q = 0, the jerk does not return to zero in the middle.
//        With jounce alone limited these are the switches of the perfect spline, at
//        sin^2(i pi/8) of the duration.
//   (3)  It is reached and held: q = 1, jerk zero, then a cruise.
//   (4)  Between them the middle touches the limit with a jerk: v and the way h/2 decide p (or d)
//        and q together.
//
// The distance of the half grows with p and d in (2), and with q at a given v in (4), so bisection
// finds these to the last bit, in any unit. (3) is the classical profile of Lambrechts et al. For
// short moves, that profile also returns the jerk to zero in the middle and takes up to 7.5 %
// longer than (2).
//
// (2) is optimal. The velocity limit is a state constraint of third order. When it is active, the
// optimum switches very often and is less than 0.1 % shorter than (3) and (4), as linear
// programming shows (tests/oracle/fourth_order.py). No machine benefits from that.

namespace jounce {
namespace {

struct Rates {
  double a, j, s;
};

struct Phase {
  double duration, jounce;
};

/// The first half of a move, with the p, d and q of the derivation.
struct Half {
  std::array<Phase, 7> phases;

  Half(double p, double d, double q, const Rates& l) {
    const double full = l.j / l.s;
    const double b1 = std::min(full, std::sqrt(p / l.s));
    const double c1 = std::max(p / l.j - full, 0.0);
    const double k = 1 - (1 - q) * (1 - q) / 2;
    const double b2 = std::min(full, std::sqrt(p / (k * l.s)));
    const double c2 = std::max(p / l.j - k * full, 0.0);  // (1)
    phases = {{{b1, l.s}, {c1, 0}, {b1, -l.s}, {d, 0}, {b2, -l.s}, {c2, 0}, {q * b2, l.s}}};
  }

  [[nodiscard]] double duration() const;
  [[nodiscard]] Jet end() const;
};

/// The state at the time t (of either sign) after x.
Jet advanced(const Jet& x, double jounce, double t) {
  return {x[0] + t * (x[1] + t * (x[2] / 2 + t * (x[3] / 6 + t * jounce / 24))),
          x[1] + t * (x[2] + t * (x[3] / 2 + t * jounce / 6)), x[2] + t * (x[3] + t * jounce / 2),
          x[3] + t * jounce};
}

double Half::duration() const {
  double t = 0;
  for (const Phase& phase : phases) t += phase.duration;
  return t;
}

Jet Half::end() const {
  Jet x{};
  for (const Phase& phase : phases) x = advanced(x, phase.jounce, phase.duration);
  return x;
}

/// The greatest x in [0, high] for which `below` holds, to the last bit.
template <class Below>
double largest(double high, const Below& below) {
  double low = 0;
  for (double middle = high / 2; low < middle && middle < high; middle = low + (high - low) / 2)
    (below(middle) ? low : high) = middle;
  return low;
}

/// The half by (2) over h/2, without a velocity limit.
Half unlimited_half(double h, const Rates& l) {
  const auto way = [&](double p, double d) { return Half(p, d, 0, l).end()[0]; };
  if (way(l.a, 0) >= h / 2)
    return {largest(l.a, [&](double p) { return way(p, 0) < h / 2; }), 0, 0, l};
  const double more = 2 * std::sqrt(h / l.a);  // in this time, a alone covers more than h/2
  return {l.a, largest(more, [&](double d) { return way(l.a, d) < h / 2; }), 0, l};
}

/// The half with the peak velocity v for a given q.
Half half_to(double v, double q, const Rates& l) {
  const double without = Half(l.a, 0, q, l).end()[1];
  if (v >= without) return {l.a, (v - without) / l.a, q, l};
  return {largest(l.a, [&](double p) { return Half(p, 0, q, l).end()[1] < v; }), 0, q, l};
}

/// The first half, and the duration of the cruise after it.
struct Plan {
  Half half;
  double cruise;
};

Plan planned(double h, double velocity, const Rates& l) {
  const Half unlimited = unlimited_half(h, l);
  if (unlimited.end()[1] <= velocity) return {unlimited, 0};
  const Half held = half_to(velocity, 1, l);
  const double rest = h - 2 * held.end()[0];
  if (rest >= 0) return {held, rest / velocity};  // (3)
  const auto way = [&](double q) { return half_to(velocity, q, l).end()[0]; };
  return {half_to(velocity, largest(1, [&](double q) { return way(q) < h / 2; }), l), 0};  // (4)
}

/// Phases shorter than this share of a move are rounding.
constexpr double negligible = 1e-15;

Segment segment(const Jet& x, const Phase& phase) {
  const double t = phase.duration;
  Segment f;
  f.length = t;
  f.c = {x[0], x[1] * t, x[2] * t * t / 2, x[3] * t * t * t / 6, phase.jounce * t * t * t * t / 24};
  for (f.degree = 4; f.degree > 1 && f.c[static_cast<std::size_t>(f.degree)] == 0;) --f.degree;
  return f;
}

/// The first half runs forwards from the start, the second one backwards in time from the end, so
/// each is exact at its own end. A cruise covers the distance between them at the planned velocity:
/// rounding of the positions changes its duration, not its velocity.
Trajectory curve(const Plan& plan, double velocity, double total, double from, double to) {
  const double sign = std::copysign(1, to - from);
  std::vector<Segment> segments, back;
  Jet x{from};
  Jet y{to};
  for (auto [t, jounce] : plan.half.phases) {
    if (t <= negligible * total) continue;
    jounce *= sign;
    segments.push_back(segment(x, {t, jounce}));
    x = advanced(x, jounce, t);
    y = advanced(y, -jounce, -t);
    back.push_back(segment(y, {t, -jounce}));
  }
  const double cruise = plan.cruise > 0 ? (y[0] - x[0]) / (sign * velocity) : 0;
  if (cruise > negligible * total) segments.push_back(line(cruise, x[0], y[0]));
  segments.insert(segments.end(), back.rbegin(), back.rend());
  return Trajectory(std::move(segments), 0, Extrapolation::hold);
}

void require(const FourthOrderSpec& spec) {
  require_finite("from", spec.from);
  require_finite("to", spec.to);
  if (spec.from == spec.to)
    throw InputError("to", spec.to,
                     "must differ from `from` = " + number(spec.from) + ": there is no move");
  require_finite("to - from", spec.to - spec.from);
  require_positive("velocity", spec.velocity);
  require_positive("acceleration", spec.acceleration);
  require_positive("jerk", spec.jerk);
  require_positive("jounce", spec.jounce);
}

}  // namespace

Trajectory fourth_order(const FourthOrderSpec& spec) {
  require(spec);
  const Rates limits{spec.acceleration, spec.jerk, spec.jounce};
  const Plan plan = planned(std::abs(spec.to - spec.from), spec.velocity, limits);
  const double total = 2 * plan.half.duration() + plan.cruise;
  if (!(total > 0 && total < INFINITY)) profiles_detail::refuse_duration(spec.to, total);
  if (plan.half.phases[0].duration <= negligible * total)
    throw InputError("jounce", spec.jounce,
                     "is so high that the ramps of the jerk are too short to compute beside the "
                     "duration of the move, " +
                         six_digits(total) + " s: lower the jounce, or use profile = \"s_curve\"");
  return curve(plan, spec.velocity, total, spec.from, spec.to);
}

}  // namespace jounce
