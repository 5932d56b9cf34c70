// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "jounce/profiles/detail/tolerances.hpp"

#include "axis/src/motion/setpoint_check.hpp"
#include "axis/src/state/axis_impl.hpp"

// The ends of a motion: at its target, by a stop, or in a fault.

namespace jounce {

void MotionAxis::Impl::conclude() {
  if (state_ == State::homing) return;  // homing sets its state itself when it ends
  if (base_ == Base::move) {
    if (!own_.player().is_over(now_.tick)) return;
    if (ending_ != Ending::none) return rest();
    if (requested_rate() == 0 || own_.repeats()) return;
    const Goal& goal = own_.goal();
    if (goal.kind == Goal::Kind::position || goal.value == 0) return rest();
    if (!own_.waiting().empty()) begin_next();
    return;
  }
  if (base_ == Base::group) {
    if (inputs_.peers == Peers::landing) rest();
    return;
  }
  if (base_ == Base::live) {
    if (live_->progress() != Progress::done) return;
    const double still = profiles_detail::rounded_input * *config_.limits.velocity;  // rounding
    if (!(std::abs(now_.velocity) > still)) return rest();
    return leave(live_->keeps_velocity() ? Goal::Kind::velocity : Goal::Kind::rest);
  }
  const bool passed = path_.finishes() && path_.reaches_boundary(now_.tick);
  if (path_->progress() == Progress::done || passed) return rest();
  const bool resumable = ending_ == Ending::fault && (now_.fault == Cause::underrun || is_group());
  if (ending_ != Ending::none && path_.rests(now_.tick) && !resumable) rest();
}

Cause MotionAxis::Impl::reason_to_rest() const {
  switch (ending_) {
    case Ending::none:
      return path_.finishes() ? Cause::pass_ended : Cause::none;
    case Ending::stop:
      return Cause::stopped;
    case Ending::release:
      return Cause::released;
    case Ending::group:
      return Cause::group_stopped;
    case Ending::halt:
      return Cause::halted;
    case Ending::table:
      return Cause::end_velocity;
    case Ending::fault:
      break;
  }
  return now_.fault;
}

/// Ends the motion, for any reason.
void MotionAxis::Impl::rest() {
  const bool stopped = ending_ >= Ending::stop && ending_ <= Ending::halt;
  if (stopped) ++now_.stopped;
  if (ending_ == Ending::none || ending_ == Ending::table) ++now_.finished;
  now_.reason = reason_to_rest();
  state_ = ending_ == Ending::fault ? State::error_stop : State::standstill;
  const bool goes_on = above_.running() && ending_ == Ending::none;
  const double more = goes_on ? above_.remaining(now_.tick) : 0;
  const MoveDynamics dynamics = above_.dynamics();
  const MotionState from = last();
  const double target = now_.position + more;
  const bool ended = ending_ != Ending::fault;
  const bool held = held_;
  freeze();
  if (!goes_on) {
    if (!own_.waiting().empty() && ended) begin_next();
    return;
  }
  // The superimposed move continues alone.
  base_ = Base::move;
  bare_ = {from, now_.tick};
  now_.velocity = from.velocity;
  now_.acceleration = from.acceleration;
  state_ = State::discrete_motion;
  held_ = held;
  if (!plan_from(bare_, {Goal::Kind::position, target, dynamics}, requested_rate()))
    fail(more > 0 ? Cause::positive_soft_limit : Cause::negative_soft_limit);
}

/// The setpoint stays at its present value; the caller sets the state.
void MotionAxis::Impl::freeze() {
  drop_movement();
  base_ = Base::rest;
  ending_ = Ending::none;
  held_ = false;
  home_.end();
  own_.forget_changes();
  above_.clear();
  now_.master_velocity = now_.velocity = now_.acceleration = 0;
}

/// Freezes in the middle of a motion.
void MotionAxis::Impl::cut_off() {
  now_.frozen = now_.velocity != 0;
  freeze();
}

void MotionAxis::Impl::fail(Cause cause, double value) {
  // The first fault stays: later ones are its consequences.
  const bool first = now_.fault == Cause::none;
  if (first) now_.fault = cause;
  if (first) now_.fault_value = value;
  if (first && moving()) now_.reason = cause;
  now_.profile.clear();
  break_groups();
  forget_next();
  forget_later();
  Reaction reaction = reaction_to(cause);
  if (cause == Cause::aborted && config_.abort_acceleration == 0) reaction = Reaction::freeze;
  // The axes of a group stop on its path in any fault, unless the setpoint itself was at fault.
  if (is_group() && on_path() && ending_ != Ending::fault && cause != Cause::stalled)
    reaction = Reaction::stop_on_path;
  if (reaction == Reaction::power_off) {
    now_.power = false;
    cut_off();
    state_ = State::disabled;
    return;
  }
  if (state_ == State::disabled) return;
  state_ = State::error_stop;
  if (!moving()) return;
  if (reaction == Reaction::freeze) return cut_off();
  if (base_ == Base::move && ending_ == Ending::fault && cause != Cause::aborted) return;
  const bool on_it = reaction == Reaction::stop_on_path && on_path() && !above_.running();
  path_.forget_boundary();
  ending_ = Ending::fault;
  if (on_it && path_.stop(request())) return;
  if (cause == Cause::positive_soft_limit || cause == Cause::negative_soft_limit) {
    const auto goal = stop_at_limit(cause, last(), dt(), config_);
    if (goal && adopt(*goal, 1)) return;
  }
  brake(cause == Cause::aborted ? config_.abort_acceleration : config_.stop_acceleration);
}

void MotionAxis::Impl::drop_movement() {
  if (const Movement* const played = active()) hand_back(played);
  path_.end();
  live_.end();
}

}  // namespace jounce
