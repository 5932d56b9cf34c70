// SPDX-License-Identifier: Apache-2.0
#include "profiles/proof/certificate.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "profiles/proof/polish.hpp"
#include "profiles/proof/program.hpp"

namespace jounce::proof {
namespace {

/// c0 + c1 s + c2 s^2 on [0, h].
struct Quadratic {
  Real c0 = 0, c1 = 0, c2 = 0;

  [[nodiscard]] Real at(Real s) const { return c0 + s * (c1 + s * c2); }
  [[nodiscard]] Real integral(Real s) const { return s * (c0 + s * (c1 / 2 + s * c2 / 3)); }
  /// Its zeros in (0, h), ascending; unused ones are h.
  [[nodiscard]] std::array<Real, 2> zeros(Real h) const {
    const Real d = c1 * c1 - 4 * c2 * c0;
    if (d < 0) return {h, h};
    const Real w = -(c1 + std::copysign(std::sqrt(d), c1)) / 2;
    const auto inside = [h](Real x) { return x > 0 && x < h ? x : h; };
    const Real x = inside(w == 0 ? h : c0 / w);
    const Real y = inside(c2 == 0 ? h : w / c2);
    return {std::min(x, y), std::max(x, y)};
  }
};

/// The largest integral of q j.
Real largest(const Quadratic& q, Real h, Real rise, Real fall) {
  const auto [x, y] = q.zeros(h);
  Real sum = 0;
  Real from = 0;
  for (const Real to : {x, y, h}) {
    const Real part = q.integral(to) - q.integral(from);
    sum += std::max(part * rise, -part * fall);
    from = to;
  }
  return sum;
}

/// The target's value, reached early and kept on with its acceleration.
Real value(const Functional& f, const Question& q, Real early) {
  const Real a = q.to.acceleration;
  const Real v = q.to.velocity;
  const Real d = q.to.position - q.start.x;
  return f.p * (d + early * (v + early * a / 2)) + f.v * (v + early * a) + f.a * a;
}

/// The least of `value` over [0, early].
Real least_value(const Functional& f, const Question& q, Real early) {
  const Real slope = f.p * q.to.velocity + f.v * q.to.acceleration;
  const Real turn = -slope / (f.p * q.to.acceleration);
  Real least = std::min(value(f, q, 0), value(f, q, early));
  if (turn > 0 && turn < early) least = std::min(least, value(f, q, turn));
  return least;
}

/// The sum (1), from T back to the start.
class Sum {
 public:
  Sum(const Functional& f, const Question& q, Real drift, Real late)
      : f_(f),
        b_(q.bounds),
        from_(q.start),
        drift_(drift),
        late_(late),
        top_(q.top),
        bottom_(q.bottom),
        q_(f.a),
        slope_(f.v) {}

  Real run();
  std::vector<Real> steps;  ///< sign changes of q

 private:
  using Flat = Functional::Flat;
  void press(Real t, Real velocity, Real acceleration);
  void hold(Real t, Real h);
  void cruise(Real t, Real h);
  void free(Real t, Real h);
  [[nodiscard]] Real velocity(Real t, bool up) const {
    return up ? top_.velocity(t) : -bottom_.velocity(t);
  }
  [[nodiscard]] Real acceleration(Real t, bool up) const {
    const Real a = from_.a;
    return up ? std::max<Real>(b_.acceleration_max, a + b_.jerk_min * t)
              : std::min<Real>(b_.acceleration_min, a + b_.jerk_max * t);
  }
  [[nodiscard]] Real drifted(Real t, Real pressure) const {
    return t > f_.at.back().t - late_ ? std::abs(pressure) * drift_ : 0;
  }

  const Functional& f_;
  const Bounds& b_;
  const Freedom& from_;
  Real drift_, late_;
  const Envelope& top_;
  const Envelope& bottom_;
  Real q_, slope_;  ///< (2) and its slope against time, where the sum has got to
  Real sum_ = 0;
};

void Sum::press(Real t, Real m, Real n) {
  if (m != 0) sum_ += m * velocity(t, m > 0) + drifted(t, m);
  if (n != 0) sum_ += n * acceleration(t, n > 0);
  slope_ -= m;
  q_ -= n;
}

/// The pressure on the acceleration takes up all the slope.
void Sum::hold(Real t, Real h) {
  press(t, 0, q_);
  const Quadratic density{slope_, f_.p, 0};
  const Real turn = density.zeros(h)[0];
  for (const auto& [from, to] : {std::pair{Real{0}, turn}, std::pair{turn, h}})
    if (const Real n = density.integral(to) - density.integral(from); n != 0)
      sum_ += n > 0 ? n * std::max(acceleration(t - from, true), acceleration(t - to, true))
                    : n * std::min(acceleration(t - from, false), acceleration(t - to, false));
  slope_ += f_.p * h;
}

/// The pressure on the velocity takes up all the curvature, where its limit is constant.
void Sum::cruise(Real t, Real h) {
  press(t, slope_, q_);
  const bool up = f_.p > 0;
  const Real limit = up ? std::max(velocity(t, true), velocity(t - h, true))
                        : std::min(velocity(t, false), velocity(t - h, false));
  sum_ += f_.p * h * limit + drifted(t, f_.p * h);
}

void Sum::free(Real t, Real h) {
  const Quadratic q{q_, slope_, f_.p / 2};
  sum_ += largest(q, h, b_.jerk_max, -b_.jerk_min);
  for (const Real s : q.zeros(h))
    if (s < h) steps.push_back(t - s);
  q_ = q.at(h);
  slope_ += f_.p * h;
}

Real Sum::run() {
  for (std::size_t i = f_.at.size(); i-- > 0;) {
    const Functional::Instant& now = f_.at[i];
    const Real h = now.t - (i > 0 ? f_.at[i - 1].t : 0);
    press(now.t, now.velocity, now.acceleration);
    if (now.before == Flat::none) free(now.t, h);
    if (now.before == Flat::acceleration) hold(now.t, h);
    if (now.before == Flat::velocity) cruise(now.t, h);
  }
  return sum_ + q_ * from_.a + slope_ * from_.v;
}

/// Length of the interval before T that the functional excludes; 0 if not even T.
Real excluded(const Functional& f, const Question& q, Real most) {
  for (Real early = most; early > most * 1e-9L; early *= 0.75L)
    if (least_value(f, q, early) > bound(f, q, std::abs(Real{q.to.acceleration}) * early, early))
      return early;
  return 0;
}

/// All the instants at which an envelope, or what was found so far, bends, and some between.
std::vector<Real> grid(const Question& q, Real T, std::vector<Real> bends, int parts) {
  for (const Envelope* e : {&q.top, &q.bottom})
    for (const Arc& arc : e->arcs) bends.push_back(arc.begin);
  for (int i = 1; i <= parts; ++i) bends.push_back(T * i / parts);
  for (Real t = T / parts; t > T * 1e-4L; t /= 2) {  // short stretches are near the ends
    bends.push_back(t);
    bends.push_back(T - t);
  }
  std::sort(bends.begin(), bends.end());
  std::vector<Real> at;
  for (const Real t : bends)
    if (t > T * 1e-9L && t <= T && (at.empty() || t - at.back() > T * 1e-9L)) at.push_back(t);
  at.back() = T;
  return at;
}

/// Bends of the next grid: the steps of the jerk, and points half-way to the neighbours of the
/// places where the functional presses.
std::vector<Real> bends(const Functional& f, const Question& q) {
  Sum sum(f, q, 0, 0);
  sum.run();
  std::vector<Real> at = std::move(sum.steps);
  for (std::size_t i = 0; i < f.at.size(); ++i) {
    at.push_back(f.at[i].t);
    const bool flat = f.at[i].before != Functional::Flat::none;
    if (const bool edge = i > 0 && flat != (f.at[i - 1].before != Functional::Flat::none); edge) {
      at.push_back((f.at[i - 1].t + f.at[i].t) / 2);
      at.push_back((f.at[i - 1].t + (i > 1 ? f.at[i - 2].t : 0)) / 2);
    }
  }
  return at;
}

}  // namespace

Real bound(const Functional& f, const Question& q, Real drift, Real late) {
  return Sum(f, q, drift, late).run();
}

namespace {

Question asked(const Freedom& start, const MotionState& to, const Bounds& b, bool position) {
  return {start,
          to,
          b,
          position,
          envelope(start.v, start.a, upper(b)),
          envelope(-start.v, -start.a, lower(b))};
}

}  // namespace

Question question(const MotionState& from, const MotionState& to, const Bounds& bounds) {
  const Force f = in_force(from, to, bounds);
  return asked(freedom(from, f.bounds, f.hold), to, f.bounds, true);
}

Question question_of_longer(const MotionState& from, const MotionState& to, const Bounds& bounds) {
  const Force f = in_force(from, to, bounds);
  return asked(freedom(from, f.longer, f.hold), to, f.longer, true);
}

Question question_of_velocity(const MotionState& from, const MotionState& to,
                              const Bounds& bounds) {
  return asked(freedom(from, bounds), to, bounds, false);
}

Real margin(const Functional& f, const Question& q) {
  return value(f, q, 0) - bound(f, q);
}

Real impossible_from(const Question& q, Real from, Real to) {
  constexpr int refinements = 8;
  const Real forced = q.start.time;
  const Real least = std::max(from - forced, Real{0});
  to -= forced;
  while (to > least) {
    Real early = 0;
    std::vector<Real> at;
    for (int i = 0; i < refinements && early == 0; ++i) {
      const Functional f = polished(proposed(q, grid(q, to, at, 16 + 4 * i)), q);
      early = excluded(f, q, to - least);
      at = bends(f, q);
    }
    if (early == 0) return forced + to;
    to = early == to - least ? least : to - early;
  }
  return from;
}

}  // namespace jounce::proof
