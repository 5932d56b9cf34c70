// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <utility>

#include "axis/src/follow/coupled_peaks.hpp"
#include "axis/src/motion/setpoint_check.hpp"
#include "axis/src/state/axis_impl.hpp"

// The moves that an axis plans itself (move_plan.hpp), each from the last output setpoint.

namespace jounce {

MotionAxis::Impl::Rejection MotionAxis::Impl::move_or_buffer(const BufferedMove& what) {
  if (buffer_of(what) != BufferMode::aborting && moving()) return buffer(what);
  return move(what);
}

MotionAxis::Impl::Rejection MotionAxis::Impl::move(const BufferedMove& what) {
  Goal goal;
  if (auto no = goal_of(what, last(), move_rules(), goal)) return no;
  return take_over(goal);
}

/// Counts from the target of the present move, if it has one.
MotionAxis::Impl::Rejection MotionAxis::Impl::act(const command::MoveAdditive& what) {
  const bool aimed = base_ == Base::move && own_.goal().kind != Goal::Kind::velocity;
  const double start = aimed ? own_.goal().value + above_.finished() : now_.position;
  Goal goal;
  if (auto no = goal_of(what, start, last(), move_rules(), goal)) return no;
  return take_over(goal);
}

/// Without a motion beneath it, it is a MoveRelative.
MotionAxis::Impl::Rejection MotionAxis::Impl::act(const command::MoveSuperimposed& what) {
  const bool under_way = moving() && ending_ == Ending::none;
  if (!under_way || state_ == State::continuous_motion)
    return move(command::MoveRelative{what.distance, what.dynamics});
  if (!std::isfinite(what.distance)) return Refusal{Cause::no_value, what.distance};
  return superimpose(what.distance, what.dynamics);
}

/// The move replaces the present motion and the waiting moves.
MotionAxis::Impl::Rejection MotionAxis::Impl::take_over(const Goal& goal) {
  const WaitingMoves waited = own_.take_all();
  if (!go(goal)) {
    own_.keep(waited);
    return Refusal{Cause::no_such_move, goal.value};
  }
  forget(waited);
  return std::nullopt;
}

MoveRules MotionAxis::Impl::move_rules() const {
  return {config_, inputs_.positive_switch, inputs_.negative_switch};
}

MoveConditions MotionAxis::Impl::conditions() const {
  return {.tick = now_.tick,
          .last_tick = last_tick_,
          .rules = rules(),
          .searches = home_.running(),
          .positive_switch = inputs_.positive_switch,
          .negative_switch = inputs_.negative_switch,
          .factor = factor_,
          .rate = requested_rate(),
          .stopping = ending_ != Ending::none,
          .added = above_.running(),
          .shifted = above_.shifts(),
          .shift = above_.finished()};
}

/// The greatest magnitudes of the motion below a superimposed move. Behind a live master, these are
/// the magnitudes that the axis needs anywhere on its cam, for the present motion of the master.
Peaks MotionAxis::Impl::beneath() const {
  if (on_path()) return path_.peaks_at_rate();
  if (base_ == Base::move) return own_.player().peaks_up_to(factor_);
  const Peaks ramp = live_->peaks();
  const Peaks phase = live_.phase().peaks(now_.tick);
  const auto& [p, v, a] = bare_.state;
  const Jet& x = inputs_.master;
  const Peaks cam =
      coupled_peaks(live_->slopes(), {std::abs(x[1]), std::abs(x[2]), std::abs(x[3])});
  return {std::max(std::abs(v), cam.velocity) + phase.velocity,
          std::max(std::abs(a), cam.acceleration + ramp.acceleration) + phase.acceleration,
          cam.jerk + ramp.jerk + phase.jerk};
}

/// Begins a move on top of the present motion, or returns the reason to reject it.
MotionAxis::Impl::Rejection MotionAxis::Impl::superimpose(double distance,
                                                          const MoveDynamics& dynamics) {
  if (on_path() && !path_.steady(now_.tick)) return Refusal{.cause = Cause::rate_changing};
  if (path_.swaps() || passes()) return Refusal{.cause = Cause::in_motion};
  if (base_ == Base::live && live_->cuts() != nullptr) return Refusal{.cause = Cause::in_cut_plan};
  const auto end = expected_end();
  return above_.begin(now_.tick, distance, dynamics, beneath(),
                      end ? std::optional(end->position) : std::nullopt);
}

/// The slave keeps its velocity (PMC600 manual 6.1, 6.2); MC_Stop or another move follows.
MotionAxis::Impl::Rejection MotionAxis::Impl::decouple() {
  if (!active()) return Refusal{Cause::not_synchronized};
  leave(Goal::Kind::velocity);
  if (base_ != Base::move) return Refusal{Cause::no_such_move};
  return std::nullopt;
}

// ---- planning ----------------------------------------------------------------------------------

/// A move replaces any present motion, and continues from its last setpoint.
bool MotionAxis::Impl::go(const Goal& goal) {
  const bool was_moving = moving();
  if (!adopt(goal, factor_)) return false;
  held_ = false;
  if (!was_moving) begun_ = bare_.tick = now_.tick;  // more commands may follow in this tick
  ending_ = Ending::none;
  now_.reason = was_moving ? Cause::replaced : Cause::none;
  state_ = goal.kind == Goal::Kind::velocity ? State::continuous_motion : State::discrete_motion;
  return true;
}

bool MotionAxis::Impl::adopt(const Goal& goal, double factor) {
  if (!plan_from({last(), moving() ? bare_.tick : now_.tick}, goal, factor)) return false;
  if (path_.swaps()) disarm();
  drop_movement();
  own_.forget_changes();
  above_.clear();
  bare_.state = last();
  base_ = Base::move;
  return true;
}

bool MotionAxis::Impl::plan_from(const TimedState& from, const Goal& goal, double factor,
                                 double ahead) {
  return own_.plan(from, goal, factor, conditions(), ahead);
}

/// Plans the move for another rate. A move that comes to rest absorbs the superimposed move.
bool MotionAxis::Impl::replan_move() {
  const double rate = requested_rate();
  if (rate > 0 || !above_.shifts()) return plan_from(bare_, own_.goal(), rate);
  Goal both = own_.goal();
  both.value += above_.distance();
  if (!plan_from({last(), bare_.tick}, both, rate)) return false;
  bare_.state = last();
  above_.clear();
  return true;
}

/// Brakes from the last good setpoint, and from the tick of its output.
void MotionAxis::Impl::brake(double deceleration) {
  const double jerk = config_.limits.jerk ? config_.stop_jerk : Bounds::none;
  for (const double a : {deceleration, std::max(deceleration, config_.stop_acceleration)}) {
    if (!adopt({Goal::Kind::rest, 0, {*config_.limits.velocity, a, a, jerk}}, 1)) return cut_off();
    ending_ = Ending::fault;
    if (stays_inside(own_.player().plan(), rules())) return;  // otherwise harder
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
  ending_ = rests ? Ending::table : Ending::none;
}

}  // namespace jounce
