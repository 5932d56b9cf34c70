// SPDX-License-Identifier: Apache-2.0
#include "axis/src/motion/motion_rules.hpp"
#include "axis/src/state/axis_impl.hpp"

// The ends of a motion: at its target, by a stop, or in a fault.

namespace jounce {

void MotionAxis::Impl::conclude() {
  if (state_ == State::homing) return;  // homing sets its state itself when it ends
  switch (sequel_of(motion_, {.tick = now_.tick,
                              .searches = home_.running(),
                              .velocity = now_.velocity,
                              .most_velocity = *config_.limits.velocity,
                              .fault = now_.fault,
                              .peers = inputs_.peers})) {
    case Sequel::goes_on:
      return;
    case Sequel::rests:
      return rest();
    case Sequel::next:
      return begin_next();
    case Sequel::keeps_velocity:
      return leave(Goal::Kind::velocity);
    case Sequel::brakes:
      return leave(Goal::Kind::rest);
  }
}

/// Ends the motion, for any reason.
void MotionAxis::Impl::rest() {
  const Ending ending = motion_.ending();
  const bool stopped = ending >= Ending::stop && ending <= Ending::halt;
  if (stopped) ++now_.stopped;
  if (!motion_.ends() || motion_.ending() == Ending::table) ++now_.finished;
  now_.reason = reason_to_rest(motion_, now_.fault);
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
  note(replaced(motion_.own().take_all()));
  note(later_.forget());
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
  if (on_it && motion_.path().stop(request())) return;
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
