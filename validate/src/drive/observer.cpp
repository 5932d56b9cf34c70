// SPDX-License-Identifier: Apache-2.0
#include "validate/src/drive/observer.hpp"

#include <algorithm>
#include <cmath>

#include "jounce/profiles/detail/tolerances.hpp"

#include "validate/src/drive/peak.hpp"

namespace jounce::validate_detail {

Observer::Observer(const DriveModel& model, const DriveOptions& options, double origin,
                   double duration)
    : model_(model),
      options_(options),
      origin_(origin),
      heat_(model.drive().motor),
      spacing_(options.samples > 1 ? duration / static_cast<double>(options.samples - 1) : 0),
      scratch_(model.size()) {
  found_.samples.reserve(options.samples);
}

Observer::Point Observer::point(const double* y, const SignalPiece& reference, double t) const {
  const Jet r = reference.at(origin_ + t);
  const double limit = model_.drive().motor.torque_limit;
  const std::size_t load = model_.load();
  return {origin_ + t,
          std::clamp(model_.torque(r, y), -limit, limit),
          y[0],
          y[load],
          y[load + 1],
          model_.motor_speed(r, y),
          model_.drive().pendulum ? y[load + 2] - y[load] : 0,
          r[0]};
}

Observer::Point Observer::between(const OdeSolver& solver, const SignalPiece& reference, double t) {
  solver.interpolate(t, scratch_);
  return point(scratch_.data(), reference, t);
}

void Observer::step(const OdeSolver& solver, const SignalPiece& reference) {
  const double h = (solver.time() - solver.before()) / 2;
  if (h == 0) return;
  const double begin = origin_ + solver.before();
  const bool goes_on = last_ && last_->time == begin && solver.integration().restarts == restarts_;
  restarts_ = solver.integration().restarts;
  const Points p{goes_on ? *last_ : between(solver, reference, solver.before()),
                 between(solver, reference, solver.before() + h),
                 point(solver.state().data(), reference, solver.time())};
  const double unit = 1 / model_.radians_per_unit();
  const auto watch = [&](Peak& peak, double Point::*what, double factor) {
    see_parabola({p[0].*what * factor, p[1].*what * factor, p[2].*what * factor}, p[0].time, h,
                 [&](double value, double where) { raise(peak, value, where); });
  };
  watch(found_.torque, &Point::torque, 1);
  watch(found_.velocity, &Point::velocity, 1);
  watch(found_.following_error, &Point::motor, -unit);
  if (model_.drive().pendulum) watch(found_.swing, &Point::swing, unit);
  for (const Interval& sync : options_.sync)
    if (p[0].time < sync.to && p[2].time > sync.from)
      watch(found_.sync_following_error, &Point::motor, -unit);
  beyond(solver, reference, p);
  if (settling_) {
    watch(found_.residual, &Point::load, unit);
    swing(p[0], p[1]);
    swing(p[1], p[2]);
    settling(solver, reference, p);
  }
  const double squared = solver.state()[model_.torque_squared()];
  const double work = solver.state()[model_.work()];
  raise(found_.i2t, heat_.after(2 * h, squared - torque_squared_), p[2].time);
  power(p, work - work_);
  torque_squared_ = squared;
  work_ = work;
  last_ = p[2];
  sample(solver, reference);
}

/// Work of a step, which the parabola of power through three points divides where it changes sign.
void Observer::power(const Points& p, double done) {
  const auto power = [](const Point& at) { return at.torque * at.velocity; };
  const double a = power(p[0]);
  const double b = power(p[1]);
  const double c = power(p[2]);
  double driving = std::max(0.0, done);
  if (std::min({a, b, c}) < 0 && std::max({a, b, c}) > 0) {
    const double h = (p[2].time - p[0].time) / 2;
    const auto part = [&](double from, double to) {  // positive part of a trapezoid
      if (from >= 0 && to >= 0) return h * (from + to) / 2;
      if (from <= 0 && to <= 0) return 0.0;
      const double top = std::max(from, to);
      return h * top * top / (2 * std::abs(to - from));
    };
    driving = std::max(driving, part(a, b) + part(b, c));
  }
  found_.energy.driving += driving;
  found_.energy.regenerated += driving - done;
}

/// The instant between a and b (either first) where `outside` changes; at a it is true.
template <class Outside>
double Observer::crossing(const OdeSolver& solver, const SignalPiece& reference, double out,
                          double in, Outside outside) {
  for (int k = 0; k < 40 && out != in; ++k) {
    const double middle = out + (in - out) / 2;
    (outside(between(solver, reference, middle - origin_)) ? out : in) = middle;
  }
  return in;
}

/// Records where the following error exceeds its limit.
void Observer::beyond(const OdeSolver& solver, const SignalPiece& reference, const Points& p) {
  if (!options_.limits.following_error) return;
  const double limit = *options_.limits.following_error * model_.radians_per_unit();
  const auto outside = [&](const Point& at) { return std::abs(at.motor) > limit; };
  auto& found = found_.beyond_following_error;
  const auto part = [&](const Point& a, const Point& b) {
    if (outside(a) && !beyond_) found.push_back({a.time, a.time}), beyond_ = true;
    if (!outside(a) && outside(b)) {
      const double entered = crossing(solver, reference, b.time, a.time, outside);
      found.push_back({entered, entered});
    } else if (outside(a) && !outside(b)) {
      found.back().to = crossing(solver, reference, a.time, b.time, outside);
    }
    beyond_ = outside(b);
    if (beyond_) found.back().to = b.time;
  };
  const double slope = (p[2].motor - p[0].motor) / 2;
  const double bend = p[0].motor - 2 * p[1].motor + p[2].motor;
  if (!(std::abs(slope) < std::abs(bend)) || outside(p[0]) || outside(p[1]) || outside(p[2])) {
    part(p[0], p[1]);
    part(p[1], p[2]);
    return;
  }
  const double vertex = p[1].time - (p[2].time - p[0].time) / 2 * slope / bend;
  const Point v = between(solver, reference, vertex - origin_);
  part(p[0], v);
  part(v, p[2]);
}

/// Records since when the load is within the band. Its entry is a zero of the dense output.
void Observer::settling(const OdeSolver& solver, const SignalPiece& reference, const Points& p) {
  if (!options_.limits.settling_band) return;
  const double band = *options_.limits.settling_band * model_.radians_per_unit();
  const auto outside = [&](const Point& at) { return std::abs(at.load) > band; };
  if (p[0].time <= end_ && outside(p[0])) inside_.reset();
  for (std::size_t i = 1; i < p.size(); ++i) {
    if (outside(p[i])) {
      inside_.reset();
    } else if (!inside_) {
      inside_ = crossing(solver, reference, p[i - 1].time, p[i].time, outside) - end_;
    }
  }
}

void Observer::swing(const Point& a, const Point& b) {
  swings_.see(a.load_speed);
  if ((a.load_speed < 0) == (b.load_speed < 0)) return;
  const double part = a.load_speed / (a.load_speed - b.load_speed);
  swings_.zero(a.time + part * (b.time - a.time));
}

void Observer::sample(const OdeSolver& solver, const SignalPiece& reference) {
  const double unit = 1 / model_.radians_per_unit();
  const double slack =
      profiles_detail::rounded_input * spacing_;  // rounding must not drop the last one
  while (found_.samples.size() < options_.samples) {
    const double t = static_cast<double>(found_.samples.size()) * spacing_;
    if (t > solver.time() + slack) return;
    const Point p = between(solver, reference, std::clamp(t, solver.before(), solver.time()));
    found_.samples.push_back({origin_ + t, p.reference, p.reference + p.motor * unit,
                              p.reference + p.load * unit, p.torque, -p.motor * unit, p.velocity});
  }
}

void Observer::finish(double least_speed, DriveResult& result) {
  found_.residual_frequency = swings_.frequency(least_speed);
  if (settling_ && options_.limits.settling_band) found_.settling_time = inside_;
  result = std::move(found_);
}

}  // namespace jounce::validate_detail
