// SPDX-License-Identifier: Apache-2.0
#include "jounce/axis/tracker.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "jounce/profiles/error.hpp"

// The filter of the master. Source: N. Morrison 1969; E. Brookner, Tracking and Kalman Filtering
// Made Easy, 1998, 1.3 and 1.4. Estimate: position x, velocity v, acceleration a. h is the time
// since the previous measurement and z the new measurement:
//
//   (1)  x- = x + v h + a h^2 / 2,   v- = v + a h,   a- = a             prediction
//   (2)  r = z - x-
//   (3)  x = x- + A r,   v = v- + B r / h,   a = a- + 2 C r / h^2
//
// Fading memory: old measurements count less and less. All eigenvalues of the error are at
// t = exp(-h / time_constant): the error decays as fast as possible with the least overshoot:
//
//   (4)  order 2:  A = 1 - t^2,   B = (1 - t)^2,                   C = 0
//   (5)  order 3:  A = 1 - t^3,   B = 3/2 (1 - t)^2 (1 + t),       C = (1 - t)^3 / 2
//
// The first measurements use (6) or (7) instead, as long as their gains are higher than those of
// (4) or (5): the least-squares line (order 2) or parabola (order 3) through all n + 1 measurements
// so far,
//
//   (6)  order 2:  A = 2 (2n + 1) / D,         B = 6 / D,              D = (n + 1)(n + 2)
//   (7)  order 3:  A = 3 (3n^2 + 3n + 2) / D,  B = 18 (2n + 1) / D,    C = 30 / D,
//                  D = (n + 1)(n + 2)(n + 3),  n >= 2
//
// The output p, v follows the estimate x*, v*. In a cycle of dt, with constant acceleration,
//
//   (8)  e = x* - (p + dt (v + v*) / 2)        position error if it ended with v*
//   (9)  v := v* + k e,   k = 2 (1 - exp(-dt / settle)) / dt
//  (10)  p := p + dt (v_before + v) / 2
//
// The position error e falls by the factor exp(-dt / settle) in each cycle, and the output follows
// a master of constant velocity or acceleration without lag. |k e| is limited to sqrt(a |e|),
// where a is here the highest acceleration of the output: the speed from which a / 2 brings the
// output to rest on its target. v changes by at most a dt in a cycle, and is limited to the highest
// velocity.

namespace jounce {
namespace {

struct Gains {
  double A = 1, B = 1, C = 0;
};

Gains fading(int order, double t) {
  const double u = 1 - t;
  if (order == 2) return {1 - t * t, u * u, 0};                  // (4)
  return {1 - t * t * t, 1.5 * u * u * (1 + t), u * u * u / 2};  // (5)
}

Gains growing(int order, double n) {
  if (order == 2 || n < 2) {  // (6)
    const double D = (n + 1) * (n + 2);
    return {2 * (2 * n + 1) / D, 6 / D, 0};
  }
  const double D = (n + 1) * (n + 2) * (n + 3);  // (7)
  return {3 * (3 * n * n + 3 * n + 2) / D, 18 * (2 * n + 1) / D, 30 / D};
}

}  // namespace

void require_valid(const TrackerSpec& spec) {
  require_positive("velocity", spec.velocity);
  require_positive("acceleration", spec.acceleration);
  require_positive("time_constant", spec.time_constant);
  require_positive("settle", spec.settle);
  require_positive("longest_age", spec.longest_age);
  require_finite("latency", spec.latency);
  if (spec.order != 2 && spec.order != 3)
    throw InputError("order", std::to_string(spec.order), "must be 2 or 3");
  require_finite("modulo", spec.modulo);
  if (spec.modulo < 0) throw InputError("modulo", spec.modulo, "must be at least 0");
  if (!(spec.jump >= 0)) throw InputError("jump", spec.jump, "must be at least 0");
}

Jet Estimate::at(double t) const {
  const double h = t - time;
  return {x + h * (v + h * a / 2), v + h * a, a, 0};
}

Estimate corrected(const Estimate& before, const TrackerSpec& spec, double time, double measured) {
  if (before.count == 0) return {time, measured, 0, 0, 1};
  const double h = time - before.time;
  const Jet f = before.at(time);     // (1)
  const double r = measured - f[0];  // (2)
  Gains g = fading(spec.order, std::exp(-h / spec.time_constant));
  const Gains young = growing(spec.order, static_cast<double>(before.count));
  if (young.B > g.B) g = young;
  return {time, f[0] + g.A * r, f[1] + g.B * r / h, f[2] + 2 * g.C * r / (h * h),
          before.count + 1};  // (3)
}

Tracked::Tracked(const TrackerSpec& spec) : spec_(spec) {
  require_valid(spec);
  if (spec_.jump == 0) spec_.jump = spec.velocity * spec.longest_age;
}

void Tracked::see(double time, double position) noexcept {
  if (!std::isfinite(time) || !std::isfinite(position)) return;
  if (estimate_.count > 0 && !(time > estimate_.time)) return;
  if (spec_.modulo > 0) {  // the turn that is nearest to the expected position
    const double expected = estimate_.count > 0 ? target(time - spec_.latency)[0] : last_;
    if (!std::isnan(expected))
      position += spec_.modulo * std::round((expected - position) / spec_.modulo);
    last_ = position;
  }
  const bool stale = time - estimate_.time > spec_.longest_age;
  const bool jumped = std::abs(position - target(time - spec_.latency)[0]) > spec_.jump;
  if (estimate_.count > 0 && (stale || jumped)) lose();
  estimate_ = corrected(estimate_, spec_, time, position);
  seen_ = time;
}

void Tracked::lose() noexcept {
  estimate_ = {};
  following_ = outrun_ = false;
  lag_ = 0;
}

/// The estimate at `time` + latency, extrapolated with an acceleration and a velocity within the
/// limits of the master.
Jet Tracked::target(double time) const {
  Estimate e = estimate_;
  e.a = std::clamp(e.a, -spec_.acceleration, spec_.acceleration);
  e.v = std::clamp(e.v, -spec_.velocity, spec_.velocity);
  Jet f = e.at(time + spec_.latency);
  f[1] = std::clamp(f[1], -spec_.velocity, spec_.velocity);
  return f;
}

/// (8) to (10)
void Tracked::follow(const Jet& target, double dt) {
  const auto [p, v, a, j] = out_;
  const double e = target[0] - (p + dt * (v + target[1]) / 2);
  const double most = std::sqrt(spec_.acceleration * std::abs(e));
  const double k = 2 * (1 - std::exp(-dt / spec_.settle)) / dt;
  double to = target[1] + std::clamp(k * e, -most, most);
  to = std::clamp(to, v - spec_.acceleration * dt, v + spec_.acceleration * dt);
  to = std::clamp(to, -spec_.velocity, spec_.velocity);
  out_ = {p + dt * (v + to) / 2, to, (to - v) / dt, 0};
}

Jet Tracked::at(double time) noexcept {
  const Jet nowhere{std::numeric_limits<double>::quiet_NaN(), 0, 0, 0};
  const bool known = estimate_.count >= spec_.order &&
                     std::abs(time - estimate_.time) <= spec_.longest_age + spec_.latency;
  if (!known) {
    following_ = outrun_ = false;
    lag_ = 0;
    return nowhere;
  }
  if (outrun_ && std::abs(estimate_.v) > spec_.velocity) return nowhere;
  const Jet f = target(time);
  if (!following_)
    out_ = {f[0], f[1], 0, 0};
  else if (time > time_)
    follow(f, time - time_);
  lag_ = f[0] - out_[0];
  outrun_ = std::abs(lag_) > spec_.jump;
  following_ = !outrun_;
  time_ = time;
  return outrun_ ? nowhere : out_;
}

}  // namespace jounce
