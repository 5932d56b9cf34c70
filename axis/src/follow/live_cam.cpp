// SPDX-License-Identifier: Apache-2.0
#include "jounce/axis/live_cam.hpp"

#include <cmath>
#include <utility>

#include "jounce/profiles/curve/extrema.hpp"
#include "jounce/profiles/detail/tolerances.hpp"

#include "axis/src/follow/coupled_peaks.hpp"
#include "axis/src/follow/live.hpp"

namespace jounce {

Cause cause_of(CouplingStatus status) {
  switch (status) {
    case CouplingStatus::ok:
      return Cause::none;
    case CouplingStatus::not_finite:
      return Cause::no_master_input;
    case CouplingStatus::master_outside_cam:
      return Cause::master_outside_cam;
    case CouplingStatus::would_reverse:
      return Cause::would_reverse;
    case CouplingStatus::master_stands:
      return Cause::master_stands;
    case CouplingStatus::no_ramp:
    case CouplingStatus::window_missed:
      break;
  }
  return Cause::no_ramp;
}

namespace {

std::array<double, 3> slopes_of(const Coupling& coupling) {
  const Placement& p = coupling.placement();
  const double third = std::abs(extrema(coupling.cam(), 3).peak().value);
  return {coupling.reach()[1], coupling.reach()[2],
          third * p.slave_scaling * std::pow(p.master_scaling, 3)};
}

}  // namespace

LiveCam::LiveCam(std::uint64_t id, std::shared_ptr<const Table> cam, const CouplingSpec& spec,
                 CamEnd end)
    : Movement(id, Course::live),
      table_(std::move(cam)),
      coupling_(table_->curve<OverMaster>(), spec),
      slopes_(slopes_of(coupling_)),
      end_(end) {}

Cause LiveCam::begin(const MotionState& axis, const Moment& now) noexcept {
  if (!axis_detail::usable(now.master)) return Cause::no_master_input;
  const Engagement in = engage(coupling_, axis, now.master, now.t);
  if (!in) return cause_of(in.status);
  place_ = axis.position + in.jump.position;
  const double near = profiles_detail::rounded_input * std::abs(coupling_.reach()[0]) +
                      profiles_detail::rounded_sum * std::abs(axis.position);
  if (!(std::abs(in.jump.position) <= near)) return Cause::start_position;
  engaged_ = in.engaged;
  released_.reset();
  beyond_.reset();
  periods_ = 0;
  progress_ = Progress::engaging;
  cause_ = Cause::none;
  last_ = axis_detail::setpoint(now.master, {axis.position, axis.velocity, axis.acceleration, 0});
  return Cause::none;
}

Setpoint LiveCam::at(const Moment& now) noexcept {
  if (progress_ == Progress::broken) return last_;
  if (released_) return last_ = {last_.master, last_.master_velocity, point(*released_, now.t)};
  if (!axis_detail::usable(now.master)) return break_off(Cause::master_lost);
  if (beyond_ && beyond_->side * (now.master[0] - beyond_->master) >= 0) return beyond(now);
  beyond_.reset();
  const Stepped step = jounce::step(coupling_, engaged_, {now.t, now.master});
  if (step.released && !step.jumped && end_ == CamEnd::extend) {
    periods_ += step.periods;
    extend(step.periods);
    return beyond(now);
  }
  if (step.released && step.jumped) return break_off(cause_of(step.status));
  engaged_ = step.engaged;
  released_ = step.released;
  periods_ += step.periods;
  progress_ = released_ ? Progress::done : step.in_sync ? Progress::running : Progress::engaging;
  const Jet slave = released_ ? step.slave : point(*table_, engaged_, now.master, now.t);
  return last_ = axis_detail::setpoint(now.master, slave);
}

Peaks LiveCam::demand(const Moment& start) const noexcept {
  const auto& [position, v, a, j] = start.master;
  const bool passes_all =
      table_->outside() == Extrapolation::wrap || table_->outside() == Extrapolation::advance;
  if (!passes_all || v * a < 0) return {};
  const Peaks need = coupled_peaks(slopes_, {.velocity = std::abs(v)});
  return {.velocity = need.velocity, .acceleration = need.acceleration};
}

std::optional<MotionState> LiveCam::first_setpoint(const Moment& now) const noexcept {
  const Stepped next = jounce::step(coupling_, engaged_, {now.t, now.master});
  return state_of({.slave = next.slave});
}

/// Extends the cam from the end at which it was left, at its ratio. Keeps the coupling at that end.
void LiveCam::extend(double side) noexcept {
  const Placement& p = engaged_.placement;
  const double X = side > 0 ? table_->end() : table_->start();
  const Jet f = table_->jet(X, side > 0 ? Side::left : Side::right);
  beyond_ = {side, (X - p.master_offset) / p.master_scaling,
             p.slave_scaling * f[0] + p.slave_offset, p.slave_scaling * p.master_scaling * f[1]};
  engaged_.master = {beyond_->master, 0, 0, 0};
}

/// A straight cam, plus the remainder of the correction.
Setpoint LiveCam::beyond(const Moment& now) noexcept {
  const auto& [side, from, slave, ratio] = *beyond_;
  const Jet& x = now.master;
  Jet y{slave + ratio * (x[0] - from), ratio * x[1], ratio * x[2], ratio * x[3]};
  const Jet c = engaged_.correction.jet(now.t, x);
  for (std::size_t k = 0; k < y.size(); ++k) y[k] += c[k];
  engaged_.time = now.t;
  progress_ = engaged_.correction.done(now.t, x[0]) ? Progress::running : Progress::engaging;
  return last_ = axis_detail::setpoint(x, y);
}

std::optional<Moment> LiveCam::pass_end(const Moment& now) const noexcept {
  if (progress_ >= Progress::done || beyond_ || !axis_detail::usable(now.master))
    return std::nullopt;
  const Due end = due({.when = Trigger::When::period_end}, coupling_.cam(), engaged_.placement,
                      {engaged_.time, engaged_.master}, {now.t, now.master});
  if (!end.at) return std::nullopt;
  return Moment{end.at->t, now.dt, end.at->master};
}

Setpoint LiveCam::break_off(Cause cause) noexcept {
  progress_ = Progress::broken;
  cause_ = cause == Cause::none ? Cause::master_lost : cause;
  return last_;
}

}  // namespace jounce
