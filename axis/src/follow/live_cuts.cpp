// SPDX-License-Identifier: Apache-2.0
#include "jounce/axis/detail/live_cuts.hpp"

#include <cmath>
#include <utility>

#include "jounce/cam/coupling/followed.hpp"

#include "axis/src/follow/live.hpp"

namespace jounce {
namespace {

/// Share of the distance that the acceleration limit covers in a cycle: a cutter this near to its
/// home position stands there.
constexpr double at_home = 0.1;

Refusal refusal_of(const CutAnswer& answer, double shift) {
  switch (answer.status) {
    case CutAnswer::Status::ok:
      break;
    case CutAnswer::Status::length:
      return {Cause::cut_length, answer.value, answer.limit};
    case CutAnswer::Status::position:
      return {Cause::cut_position, answer.value + shift, answer.limit + shift};
    case CutAnswer::Status::pending:
      return {Cause::cut_pending, answer.limit + shift, answer.limit + shift};
    case CutAnswer::Status::far:
      return {Cause::cut_too_far, answer.value + shift, answer.limit + shift};
  }
  return {};
}

}  // namespace

LiveCuts::LiveCuts(std::uint64_t id, std::shared_ptr<const CutTask> task, const AxisConfig& config)
    : Movement(id, Course::live),
      task_(std::move(task)),
      plan_(task_, 0),
      bounds_(within(*config.limits.velocity, *config.limits.acceleration,
                     config.limits.jerk.value_or(Bounds::none))) {
  const double dt = seconds(config.period);
  near_ = at_home * *config.limits.acceleration * dt * dt;
}

Cause LiveCuts::begin(const MotionState& axis, const Moment& now) noexcept {
  if (!axis_detail::usable(now.master) || !(std::abs(axis.position) <= most_magnitude))
    return Cause::no_master_input;
  if (axis.velocity != 0) return Cause::in_motion;
  const double turn = task_->cutter.turn();
  base_ = turn > 0 ? std::round(axis.position / turn + 0.5) * turn : 0;
  place_ = base_ + task_->cutter.home() - turn;
  if (!(std::abs(axis.position - place_) <= near_)) return Cause::cutter_away;
  plan_ = CutPlan(task_, now.master[0]);
  parks_ = false;
  home_.reset();
  cause_ = Cause::none;
  progress_ = Progress::waiting;
  web_velocity_ = now.master[1];
  last_ = axis_detail::setpoint(now.master, {axis.position, 0, 0, 0});
  return Cause::none;
}

Setpoint LiveCuts::at(const Moment& now) noexcept {
  if (progress_ >= Progress::done) return last_;
  if (!axis_detail::usable(now.master)) {
    progress_ = Progress::broken;
    cause_ = Cause::master_lost;
    return last_;
  }
  web_velocity_ = now.master[1];
  if (home_ || (parks_ && leaves(now))) return way_home(now);
  Jet y = plan_.at(now.master[0]);
  if (plan_.lost()) {
    progress_ = Progress::broken;
    cause_ = Cause::master_reversed;
    return last_;
  }
  const bool rests = plan_.phase() == CutPlan::Phase::home;
  progress_ = !rests ? Progress::running : parks_ ? Progress::done : Progress::waiting;
  y[0] += base_;
  return last_ = axis_detail::setpoint(now.master, chained(y, now.master));
}

std::optional<Refusal> LiveCuts::cut(const command::Cut& what, double shift) noexcept {
  if (parks_ || progress_ >= Progress::done) return Refusal{Cause::no_cut_plan};
  const auto given = [](double number) { return !std::isnan(number); };
  const int count =
      (given(what.length) ? 1 : 0) + (given(what.position) ? 1 : 0) + (given(what.waste) ? 1 : 0);
  if (count > 1) return Refusal{Cause::no_value};
  if (count == 0 && !(web_velocity_ > 0)) return Refusal{Cause::web_stands};
  const CutAnswer answer = given(what.length)     ? plan_.set_length(what.length)
                           : given(what.waste)    ? plan_.add_waste(what.waste)
                           : given(what.position) ? plan_.cut_at(what.position - shift)
                                                  : plan_.cut_now();
  if (answer) return std::nullopt;
  return refusal_of(answer, shift);
}

void LiveCuts::park() noexcept {
  parks_ = true;
  plan_.finish();
}

/// True if the cutter leaves the web now: plans its way home from the last setpoint.
bool LiveCuts::leaves(const Moment& now) noexcept {
  const CutPlan::Phase phase = plan_.phase();
  if (plan_.in_sync() || phase == CutPlan::Phase::home) return false;
  const Cutter& cutter = task_->cutter;
  const MotionState from = state_of(last_);
  double home = 0;
  if (cutter.turn() > 0) {
    if (phase == CutPlan::Phase::approach || phase == CutPlan::Phase::link) return false;
    home = base_ + static_cast<double>(plan_.cuts() - 1) * cutter.turn() + cutter.home();
    const MoveResult stop = jounce::stop(from, bounds_);
    if (!stop || stop.profile.end().position > home) return false;
  }
  const MoveResult move = move_to(from, {home, 0, 0}, bounds_);
  if (!move) return false;
  home_ = move.profile;
  home_start_ = now.t - now.dt;
  return true;
}

Setpoint LiveCuts::way_home(const Moment& now) noexcept {
  const double t = now.t - home_start_;
  const bool over = t >= home_->duration();
  progress_ = over ? Progress::done : Progress::running;
  const Motion y = home_->at(t);
  const Jet slave = over ? Jet{home_->end().position, 0, 0, 0}
                         : Jet{y.position, y.velocity, y.acceleration, y.jerk};
  return last_ = axis_detail::setpoint(now.master, slave);
}

}  // namespace jounce
