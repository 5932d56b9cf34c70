#include "jounce/validate/detail/observer.hpp"

#include <algorithm>
#include <cmath>

namespace jounce::detail {
namespace {

void raise(Peak& peak, double value, double where) {
  if (std::abs(value) > std::abs(peak.value)) peak = {value, where};
}

/// The three values at t, t + h, t + 2 h, and the vertex of the parabola through them if it lies
/// between.
void raise(Peak& peak, const std::array<double, 3>& f, double t, double h) {
  for (std::size_t i = 0; i < f.size(); ++i) raise(peak, f[i], t + static_cast<double>(i) * h);
  const double slope = (f[2] - f[0]) / 2;
  const double bend = f[0] - 2 * f[1] + f[2];
  if (std::abs(slope) < std::abs(bend))
    raise(peak, f[1] - slope * slope / (2 * bend), t + h * (1 - slope / bend));
}

}  // namespace

Observer::Observer(const DriveModel& model, double origin, double duration, std::size_t samples)
    : model_(model),
      origin_(origin),
      spacing_(samples > 1 ? duration / static_cast<double>(samples - 1) : 0),
      wanted_(samples) {
  samples_.reserve(samples);
}

Observer::Point Observer::point(const Solver& solver, const Piece& reference, double t) const {
  DriveModel::Values y;
  solver.interpolate(t, y);
  const Jet r = reference.at(origin_ + t);
  const double limit = model_.torque_limit();
  return {origin_ + t,
          std::clamp(model_.torque(r, y.data()), -limit, limit),
          y[DriveModel::motor],
          y[DriveModel::load],
          y[DriveModel::load_speed],
          r[0]};
}

void Observer::step(const Solver& solver, const Piece& reference) {
  const double h = (solver.time() - solver.before()) / 2;
  if (h == 0) return;
  const Point a = point(solver, reference, solver.before());
  const Point b = point(solver, reference, solver.before() + h);
  const Point c = point(solver, reference, solver.time());
  const double unit = 1 / model_.radians_per_unit();
  raise(torque_, {a.torque, b.torque, c.torque}, a.time, h);
  raise(following_error_, {-a.motor * unit, -b.motor * unit, -c.motor * unit}, a.time, h);
  if (settling_) {
    raise(residual_, {a.load * unit, b.load * unit, c.load * unit}, a.time, h);
    swing(a, b);
    swing(b, c);
  }
  sample(solver, reference);
}

void Observer::swing(const Point& a, const Point& b) {
  speed_ = std::max(speed_, std::abs(a.load_speed));
  if ((a.load_speed < 0) == (b.load_speed < 0)) return;
  const double part = a.load_speed / (a.load_speed - b.load_speed);
  zeros_.push_back({a.time + part * (b.time - a.time), speed_});
  speed_ = 0;
}

double Observer::frequency(double noise) const {
  if (zeros_.empty()) return 0;
  // The swing before the first zero began before the watch: only what lies between zeros counts.
  double fastest = 0;
  for (std::size_t i = 1; i < zeros_.size(); ++i) fastest = std::max(fastest, zeros_[i].speed);
  const double least = std::max(noise, 0.01 * fastest);
  std::size_t swings = 0;
  while (swings + 1 < zeros_.size() && zeros_[swings + 1].speed >= least) ++swings;
  if (swings < 2) return 0;
  return static_cast<double>(swings) / (2 * (zeros_[swings].time - zeros_[0].time));
}

void Observer::sample(const Solver& solver, const Piece& reference) {
  const double unit = 1 / model_.radians_per_unit();
  const double slack = 1e-9 * spacing_;  // the last one must not be lost to rounding
  while (samples_.size() < wanted_) {
    const double t = static_cast<double>(samples_.size()) * spacing_;
    if (t > solver.time() + slack) return;
    const Point p = point(solver, reference, std::clamp(t, solver.before(), solver.time()));
    samples_.push_back({origin_ + t, p.reference, p.reference + p.motor * unit,
                        p.reference + p.load * unit, p.torque, -p.motor * unit});
  }
}

}  // namespace jounce::detail
