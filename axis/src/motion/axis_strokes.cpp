// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "axis/src/state/axis_impl.hpp"

// Changes of a move in progress: repetitive moves, and a new velocity, at once or at a position.

namespace jounce {

// ---- repetitive moves ----------------------------------------------------------------------------

MotionAxis::Impl::Rejection MotionAxis::Impl::act(const command::MoveRepetitive& what) {
  const double start = now_.position;
  Goal there;
  Goal back;
  const command::MoveAbsolute first{what.position, what.dynamics};
  if (auto no = goal_of(first, last(), move_rules(), there)) return no;
  const MotionState other{there.value, 0, 0};
  if (auto no = goal_of(command::MoveRelative{start - there.value, what.dynamics}, other, {config_},
                        back))
    return no;
  if (!std::isfinite(what.wait)) return Refusal{Cause::no_value, what.wait};
  // Several strokes in a tick are not a motion.
  const auto stroke = plan(other, back, 1, config_);
  const double least = seconds(config_.period);
  if (!stroke || there.value == start || !(stroke->duration() + what.wait >= least))
    return Refusal{Cause::no_such_move, there.value};
  if (auto no = take_over(there)) return no;
  repetition_.emplace(start, there.value, what.wait, what.strokes);
  return std::nullopt;
}

/// Begins the strokes that are due, each from the instant at which the rest before it has ended.
Cause MotionAxis::Impl::begin_strokes() {
  if (!repetition_ || ending_ != Ending::none || !(requested_rate() > 0)) return Cause::none;
  while (repetition_->goes_on() && move_.is_over(now_.tick)) {
    const double ahead = move_.beyond(now_.tick) - repetition_->wait();
    if (ahead < 0) break;
    Goal goal = move_.goal();
    const MotionState from{goal.value, 0, 0};
    goal.value = repetition_->next();
    repetition_->turn();
    if (!plan_from({from, now_.tick}, goal, factor_, ahead)) return Cause::jump;
  }
  return Cause::none;
}

bool MotionAxis::Impl::repeats() const {
  return repetition_ && repetition_->goes_on();
}

// ---- another velocity ----------------------------------------------------------------------------

MotionAxis::Impl::Rejection MotionAxis::Impl::act(const command::ChangeVelocity& what) {
  if (ending_ != Ending::none) return Refusal{Cause::halting};
  const bool has_velocity = base_ == Base::move && move_.goal().kind != Goal::Kind::rest &&
                            !(move_.goal().kind == Goal::Kind::velocity && move_.goal().value == 0);
  if (!has_velocity) return Refusal{Cause::not_a_move};
  if (!std::isfinite(what.velocity)) return Refusal{Cause::no_value, what.velocity};
  if (!(what.velocity > 0)) return Refusal{Cause::not_positive, what.velocity};
  if (what.velocity > *config_.limits.velocity)
    return Refusal{Cause::velocity_limit, what.velocity, *config_.limits.velocity};
  if (std::isnan(what.position)) return change_velocity(what.velocity, bare_, 0);
  if (!std::isfinite(what.position)) return Refusal{Cause::no_value, what.position};
  change_ = what;
  return std::nullopt;
}

/// Plans the move again, with another velocity, from a state that it had `ahead` s before the tick
/// of this state.
MotionAxis::Impl::Rejection MotionAxis::Impl::change_velocity(double velocity,
                                                              const TimedState& from,
                                                              double ahead) {
  Goal goal = move_.goal();
  // The superimposed move was planned within the limits that the present velocity left.
  if (above_.running() && velocity > goal.dynamics.velocity)
    return Refusal{Cause::in_motion, velocity, goal.dynamics.velocity};
  goal.dynamics.velocity = velocity;
  if (goal.kind == Goal::Kind::velocity) goal.value = std::copysign(velocity, goal.value);
  if (!plan_from(from, goal, requested_rate(), ahead))
    return Refusal{Cause::no_such_move, velocity};
  return std::nullopt;
}

/// Applies the change that waits for a position, from the instant at which the move passes it. A
/// change that is not possible is dropped: the move continues unchanged.
void MotionAxis::Impl::change_if_passed() {
  if (!change_ || ending_ != Ending::none || !(requested_rate() > 0)) return;
  const double place = change_->position - above_.finished();
  const auto ago = move_.passed(place, change_->direction, last_tick_, now_.tick);
  if (!ago) return;
  const double velocity = change_->velocity;
  change_.reset();
  if (const auto no = change_velocity(velocity, {move_.state(now_.tick, *ago), now_.tick}, *ago))
    now_.dropped = no;
}

}  // namespace jounce
