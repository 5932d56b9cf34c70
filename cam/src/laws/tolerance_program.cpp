// SPDX-License-Identifier: Apache-2.0
#include "cam/src/laws/tolerance_program.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "cam/src/design/table.hpp"

// Minimizes E(y), the least integral of geo_jerk^2 of all curves through (x_i, y_i) with |y_i -
// given_i| <= tolerance_i. E is a convex quadratic function of y. If some points are pinned to a
// bound and the others are free, the quintic spline through only the pinned points has the least
// value: a free point leaves no joint, so the system stays small and well conditioned for any
// density of the table. At a pinned point (least_energy.cpp)
//
//   (1)  dE/dy_i = 2 (f^(5)(x_i-) - f^(5)(x_i+)),   f^(5) = 0 beyond a natural end
//
// and everywhere else this derivative is zero. The curve is optimal if every free point is within
// its tolerance and
//
//   (2)  dE/dy_i >= 0 if y_i is at its lower bound, <= 0 if it is at its upper one.
//
// E is convex, so for every z within the tolerances
//
//   (3)  E(z) >= E(y) + sum dE/dy_i (z_i - y_i) >= E(y) - gap,
//        gap = sum of |dE/dy_i| 2 tolerance_i over the pins that violate (2)
//
// Parabolas (periodic: constants) have no jerk. If too few points are pinned to determine one, a
// few others are held at their present values; then E = 0 for any values.
//
// Descent: y moves straight towards the minimum of its face (the pinned points stay), and E falls
// all the way. If a point reaches a bound on the way, it is pinned, and the search continues in the
// rest of the face. After at most as many steps as there are points, the search reaches the minimum
// of a face. There it releases all pins that violate (2), so the next step lowers E. E is therefore
// lower at every such minimum than at the previous one; no face recurs, and there are finitely many
// faces. (Of the pins that are released together, some may be pinned again at once, but not the
// last one: alone, it moves inwards.)

namespace jounce::cam_detail {
namespace {

constexpr double slack = 1e-9;  ///< relative to a tolerance: not a violation

/// The number of points that determine a curve with these ends and no jerk.
std::size_t determining(const SplineSpec& spec) {
  if (spec.ends == SplineEnds::periodic) return 1;
  const auto slopes = (spec.start.geo_velocity ? 1U : 0U) + (spec.end.geo_velocity ? 1U : 0U);
  const bool bent = spec.start.geo_acceleration || spec.end.geo_acceleration;
  return 3U - std::min(2U, slopes + (bent ? 1U : 0U));
}

double fifth_derivative(const Segment& f) {
  const double h = f.length;
  return 120 * f.c[5] / (h * h * h * h * h);
}

}  // namespace

ToleranceProgram::ToleranceProgram(const SplineSpec& spec)
    : spec_(spec),
      periodic_(spec.ends == SplineEnds::periodic),
      determining_(std::min(determining(spec), spec.points.size())) {
  for (const SplinePoint& p : spec.points) rounding_ = std::max(rounding_, std::abs(p.slave));
  rounding_ *= 16 * std::numeric_limits<double>::epsilon();
}

ToleranceProgram::Solution ToleranceProgram::solve() const {
  Solution s = start();
  std::vector<double> now;
  for (const SplinePoint& p : spec_.points) now.push_back(p.slave);
  const int most = 1000 + 20 * static_cast<int>(now.size());  // against rounding: (3) remains true
  while (s.solutions < most && !s.optimal) {
    minimum_of_face(s, now);
    if (advance(s, now)) s.optimal = !release_wrong(s);
  }
  return s;
}

double ToleranceProgram::gap(const Solution& s) const {
  double sum = 0;
  for (std::size_t i = 0; i < s.pins.size() - (periodic_ ? 1 : 0); ++i)
    if (wrong(s, i)) sum += std::abs(s.gradient[i]) * 2 * spec_.points[i].tolerance;  // (3)
  return sum;
}

ToleranceProgram::Solution ToleranceProgram::start() const {
  Solution s;
  for (const SplinePoint& p : spec_.points)
    s.pins.push_back(p.tolerance == 0 ? Pin::exact : Pin::none);
  return s;
}

/// The minimum of the face; `now` gives the values of the points to hold.
void ToleranceProgram::minimum_of_face(Solution& s, const std::vector<double>& now) const {
  hold(s.pins);
  s.joints.clear();
  for (std::size_t i = 0; i < s.pins.size(); ++i)
    if (s.pins[i] != Pin::none || i == 0 || i + 1 == s.pins.size()) s.joints.push_back(i);
  auto knots = knots_of(s, now);
  minimize(knots, Energy::jerk, periodic_);
  s.segments = segments_between(knots, Energy::jerk);
  s.at.assign(s.pins.size(), 0);
  for (std::size_t k = 0; k < knots.size(); ++k) s.at[s.joints[k]] = knots[k].state[0];
  evaluate(s);
  ++s.solutions;
}

void ToleranceProgram::hold(std::vector<Pin>& pins) const {
  std::replace(pins.begin(), pins.end(), Pin::held, Pin::none);
  const std::size_t last = pins.size() - 1;
  const auto free = static_cast<std::size_t>(
      std::count(pins.begin(), pins.end() - (periodic_ ? 1 : 0), Pin::none));
  std::size_t pinned = last + (periodic_ ? 0 : 1) - free;
  std::vector<std::size_t> order{0, last, last / 2};
  for (std::size_t i = 1; i < std::min<std::size_t>(last, 6); ++i) order.push_back(i);
  for (const std::size_t i : order)
    if (pinned < determining_ && pins[i] == Pin::none) {
      pins[i] = Pin::held;
      ++pinned;
    }
  if (periodic_) pins[last] = pins[0];
}

std::vector<EnergyKnot> ToleranceProgram::knots_of(const Solution& s,
                                                   const std::vector<double>& now) const {
  std::vector<EnergyKnot> knots;
  for (const std::size_t i : s.joints) {
    const Pin pin = s.pins[i];
    const bool moves = pin == Pin::none || pin == Pin::held;
    knots.push_back({spec_.points[i].master,
                     {moves ? now[i] : bound(i, pin), 0, 0},
                     {pin != Pin::none, false, false}});
  }
  give(knots.front(), spec_.start);
  give(knots.back(), spec_.end);
  return knots;
}

/// Computes the values between the joints, and (1) at them.
void ToleranceProgram::evaluate(Solution& s) const {
  s.gradient.assign(s.pins.size(), 0);
  for (std::size_t k = 0; k < s.segments.size(); ++k) {
    const std::size_t from = s.joints[k];
    const std::size_t to = s.joints[k + 1];
    const Segment& f = s.segments[k];
    for (std::size_t i = from + 1; i < to; ++i)
      s.at[i] = value(f, (spec_.points[i].master - spec_.points[from].master) / f.length);
    s.gradient[from] -= 2 * fifth_derivative(f);
    s.gradient[to] += 2 * fifth_derivative(f);
  }
  if (periodic_) s.gradient.front() = s.gradient.back() += s.gradient.front();
}

/// True if a pin violates (2).
bool ToleranceProgram::wrong(const Solution& s, std::size_t i) const {
  return (s.pins[i] == Pin::lower && s.gradient[i] < 0) ||
         (s.pins[i] == Pin::upper && s.gradient[i] > 0);
}

bool ToleranceProgram::release_wrong(Solution& s) const {
  bool any = false;
  for (std::size_t i = 0; i < s.pins.size(); ++i)
    if (wrong(s, i)) {
      s.pins[i] = Pin::none;
      any = true;
    }
  return any;
}

/// Signed excess of a value over the tolerance of a point; 0: inside.
double ToleranceProgram::excess(std::size_t i, double value) const {
  const SplinePoint& p = spec_.points[i];
  const double off = value - p.slave;
  if (std::abs(off) <= p.tolerance * (1 + slack) + rounding_) return 0;
  return off > 0 ? off - p.tolerance : off + p.tolerance;
}

double ToleranceProgram::bound(std::size_t i, Pin pin) const {
  const SplinePoint& p = spec_.points[i];
  if (pin == Pin::exact) return p.slave;
  return pin == Pin::lower ? p.slave - p.tolerance : p.slave + p.tolerance;
}

void ToleranceProgram::set(Solution& s, std::size_t i, Pin pin) const {
  s.pins[i] = pin;
  const std::size_t last = s.pins.size() - 1;
  if (periodic_ && i == 0) s.pins[last] = pin;
  if (periodic_ && i == last) s.pins[0] = pin;
}

/// Steps towards the solution and returns true if it was reached. Pins the point that stops the
/// step.
bool ToleranceProgram::advance(Solution& s, std::vector<double>& now) const {
  double step = 1;
  std::size_t stopped = s.pins.size();
  Pin by = Pin::none;
  for (std::size_t i = 0; i < s.pins.size(); ++i) {
    const double e = s.pins[i] == Pin::none ? excess(i, s.at[i]) : 0;
    if (e == 0) continue;
    const Pin side = e > 0 ? Pin::upper : Pin::lower;
    const double until = std::clamp((bound(i, side) - now[i]) / (s.at[i] - now[i]), 0.0, 1.0);
    if (stopped < s.pins.size() && until >= step) continue;
    step = until;
    stopped = i;
    by = side;
  }
  for (std::size_t i = 0; i < now.size(); ++i) now[i] += step * (s.at[i] - now[i]);
  if (stopped == s.pins.size()) {
    now = s.at;
    return true;
  }
  set(s, stopped, by);
  return false;
}

}  // namespace jounce::cam_detail
