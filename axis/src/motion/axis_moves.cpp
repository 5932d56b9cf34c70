// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <utility>

#include "axis/src/motion/setpoint_check.hpp"
#include "axis/src/state/axis_impl.hpp"

// The moves that an axis plans itself (move_plan.hpp), each from the last output setpoint.

namespace jounce {

MotionAxis::Impl::Rejection MotionAxis::Impl::move_or_buffer(const BufferedMove& what) {
  if (buffer_of(what) != BufferMode::aborting && moving()) return motion_.buffer(what, present());
  return move(what);
}

MotionAxis::Impl::Rejection MotionAxis::Impl::move(const BufferedMove& what) {
  Goal goal;
  if (auto no = goal_of(what, last(), move_rules(), goal)) return no;
  return take_over(goal);
}

/// Counts from the target of the present move, if it has one.
MotionAxis::Impl::Rejection MotionAxis::Impl::move_on(const command::MoveAdditive& what) {
  const double start = motion_.additive_start(now_.position);
  Goal goal;
  if (auto no = goal_of(what, start, last(), move_rules(), goal)) return no;
  return take_over(goal);
}

/// Without a motion beneath it, it is a MoveRelative.
MotionAxis::Impl::Rejection MotionAxis::Impl::superimpose(const command::MoveSuperimposed& what) {
  const bool under_way = moving() && !motion_.ends();
  if (!under_way || state_ == State::continuous_motion)
    return move(command::MoveRelative{what.distance, what.dynamics});
  if (!std::isfinite(what.distance)) return Refusal{Cause::no_value, what.distance};
  return motion_.superimpose(what.distance, what.dynamics, present());
}

/// The move replaces the present motion and the waiting moves.
MotionAxis::Impl::Rejection MotionAxis::Impl::take_over(const Goal& goal) {
  const WaitingMoves waited = motion_.own().take_all();
  if (!go(goal)) {
    motion_.own().keep(waited);
    return Refusal{Cause::no_such_move, goal.value};
  }
  note(replaced(waited));
  return std::nullopt;
}

MoveRules MotionAxis::Impl::move_rules() const {
  return {config_, inputs_.positive_switch, inputs_.negative_switch};
}

MotionAxis::Impl::Rejection MotionAxis::Impl::repeat(const command::MoveRepetitive& what) {
  const double start = now_.position;
  Goal there;
  if (auto no = motion_.own().first_stroke(what, last(), motion_.conditions(present()), there))
    return no;
  if (auto no = take_over(there)) return no;
  motion_.own().repeat(what, start);
  return std::nullopt;
}

/// The slave keeps its velocity (PMC600 manual 6.1, 6.2); MC_Stop or another move follows.
MotionAxis::Impl::Rejection MotionAxis::Impl::decouple() {
  if (!motion_.movement()) return Refusal{Cause::not_synchronized};
  leave(Goal::Kind::velocity);
  if (!motion_.is_move()) return Refusal{Cause::no_such_move};
  return std::nullopt;
}

// ---- planning ----------------------------------------------------------------------------------

/// A move replaces any present motion, and continues from its last setpoint.
bool MotionAxis::Impl::go(const Goal& goal) {
  const bool was_moving = moving();
  if (!adopt(goal, motion_.factor())) return false;
  motion_.let_go();
  if (!was_moving) motion_.begin_at(now_.tick);  // more commands may follow in this tick
  motion_.end_by(Ending::none);
  now_.reason = was_moving ? Cause::replaced : Cause::none;
  state_ = goal.kind == Goal::Kind::velocity ? State::continuous_motion : State::discrete_motion;
  return true;
}

bool MotionAxis::Impl::adopt(const Goal& goal, double factor) {
  if (!motion_.plan(goal, factor, present())) return false;
  if (motion_.path().swaps()) disarm();
  drop_movement();
  motion_.begin_move(last());
  return true;
}

/// Brakes from the last good setpoint, and from the tick of its output.
void MotionAxis::Impl::brake(double deceleration) {
  const double jerk = config_.limits.jerk ? config_.stop_jerk : Bounds::none;
  for (const double a : {deceleration, std::max(deceleration, config_.stop_acceleration)}) {
    if (!adopt({Goal::Kind::rest, 0, {*config_.limits.velocity, a, a, jerk}}, 1)) return cut_off();
    motion_.end_by(Ending::fault);
    if (stays_inside(motion_.own().player().plan(), home_.rules())) return;  // otherwise harder
  }
}

/// The coupling ends: the velocity stays, or the axis comes to rest.
void MotionAxis::Impl::leave(Goal::Kind kind) {
  const bool rests = kind == Goal::Kind::rest;
  MoveDynamics dynamics;
  fill(dynamics, config_);
  const double most = *config_.limits.velocity;
  const double velocity = rests ? 0 : std::clamp(now_.velocity, -most, most);
  if (!adopt({kind, velocity, dynamics}, 1)) return fail(Cause::jump);
  state_ = rests ? State::discrete_motion : State::continuous_motion;
  motion_.end_by(rests ? Ending::table : Ending::none);
}

}  // namespace jounce
