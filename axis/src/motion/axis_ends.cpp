// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "jounce/profiles/detail/tolerances.hpp"

#include "axis/src/motion/setpoint_check.hpp"
#include "axis/src/state/axis_impl.hpp"

// The ends of a motion: at its target, by a stop, or in a fault.

namespace jounce {

void MotionAxis::Impl::conclude() {
  if (state_ == State::homing) return;  // homing sets its state itself when it ends
  if (motion_.is_move()) {
    if (!motion_.own().player().is_over(now_.tick)) return;
    if (motion_.ends()) return rest();
    if (motion_.requested_rate(home_.running()) == 0 || motion_.own().repeats()) return;
    const Goal& goal = motion_.own().goal();
    if (goal.kind == Goal::Kind::position || goal.value == 0) return rest();
    if (!motion_.own().waiting().empty()) begin_next();
    return;
  }
  if (motion_.in_group()) {
    if (inputs_.peers == Peers::landing) rest();
    return;
  }
  if (motion_.is_live()) {
    if (motion_.live()->progress() != Progress::done) return;
    const double still = profiles_detail::rounded_input * *config_.limits.velocity;  // rounding
    if (!(std::abs(now_.velocity) > still)) return rest();
    return leave(motion_.live()->keeps_velocity() ? Goal::Kind::velocity : Goal::Kind::rest);
  }
  const bool passed = motion_.path().finishes() && motion_.path().reaches_boundary(now_.tick);
  if (motion_.path()->progress() == Progress::done || passed) return rest();
  const bool resumable =
      motion_.ending() == Ending::fault && (now_.fault == Cause::underrun || is_group());
  if (motion_.ends() && motion_.path().rests(now_.tick) && !resumable) rest();
}

Cause MotionAxis::Impl::reason_to_rest() const {
  switch (motion_.ending()) {
    case Ending::none:
      return motion_.path().finishes() ? Cause::pass_ended : Cause::none;
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
  const Ending ending = motion_.ending();
  const bool stopped = ending >= Ending::stop && ending <= Ending::halt;
  if (stopped) ++now_.stopped;
  if (!motion_.ends() || motion_.ending() == Ending::table) ++now_.finished;
  now_.reason = reason_to_rest();
  state_ = motion_.ending() == Ending::fault ? State::error_stop : State::standstill;
  const bool goes_on = motion_.above().running() && !motion_.ends();
  const double more = goes_on ? motion_.above().remaining(now_.tick) : 0;
  const MoveDynamics dynamics = motion_.above().dynamics();
  const MotionState from = last();
  const double target = now_.position + more;
  const bool ended = motion_.ending() != Ending::fault;
  const bool held = motion_.held();
  freeze();
  if (!goes_on) {
    if (!motion_.own().waiting().empty() && ended) begin_next();
    return;
  }
  // The superimposed move continues alone.
  now_.velocity = from.velocity;
  now_.acceleration = from.acceleration;
  state_ = State::discrete_motion;
  if (!motion_.continue_above(from, {Goal::Kind::position, target, dynamics}, held, present()))
    fail(more > 0 ? Cause::positive_soft_limit : Cause::negative_soft_limit);
}

/// The setpoint stays at its present value; the caller sets the state.
void MotionAxis::Impl::freeze() {
  drop_movement();
  motion_.rest();
  home_.end();
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
  if (is_group() && on_path() && motion_.ending() != Ending::fault && cause != Cause::stalled)
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
  if (motion_.is_move() && motion_.ending() == Ending::fault && cause != Cause::aborted) return;
  const bool on_it = reaction == Reaction::stop_on_path && on_path() && !motion_.above().running();
  motion_.path().forget_boundary();
  motion_.end_by(Ending::fault);
  if (on_it && motion_.path().stop(motion_.request(present()))) return;
  if (cause == Cause::positive_soft_limit || cause == Cause::negative_soft_limit) {
    const auto goal = stop_at_limit(cause, last(), dt(), config_);
    if (goal && adopt(*goal, 1)) return;
  }
  brake(cause == Cause::aborted ? config_.abort_acceleration : config_.stop_acceleration);
}

void MotionAxis::Impl::drop_movement() {
  if (const Movement* const played = motion_.end_movement()) hand_back(played);
}

}  // namespace jounce
