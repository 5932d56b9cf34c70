// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <utility>
#include <variant>

#include "jounce/axis/axis.hpp"
#include "jounce/axis/setpoint_check.hpp"

// The moves that an axis plans itself (move_plan.hpp), each from the last output setpoint.

namespace jounce {

template <class Move>
MotionAxis::Rejection MotionAxis::move(const Move& what) {
  Goal goal;
  if (auto no = goal_of(what, last(), goal)) return no;
  const WaitingMoves waited = std::exchange(next_, {});
  if (!go(goal)) {
    next_ = waited;
    return Refusal{Cause::no_such_move, goal.value};
  }
  forget(waited);
  return std::nullopt;
}

template <class Move>
MotionAxis::Rejection MotionAxis::move_or_buffer(const Move& what) {
  if (what.buffer != BufferMode::aborting && moving()) return buffer(what);
  return move(what);
}

MotionAxis::Rejection MotionAxis::act(const command::MoveAbsolute& what) {
  return move_or_buffer(what);
}

MotionAxis::Rejection MotionAxis::act(const command::MoveRelative& what) {
  return move_or_buffer(what);
}

MotionAxis::Rejection MotionAxis::act(const command::MoveVelocity& what) {
  return move_or_buffer(what);
}

MotionAxis::Rejection MotionAxis::act(const command::MoveAdditive& what) {
  return move(what);
}

/// Without a motion beneath it, it is a MoveRelative.
MotionAxis::Rejection MotionAxis::act(const command::MoveSuperimposed& what) {
  const bool under_way = moving() && ending_ == Ending::none;
  if (!under_way || state_ == State::continuous_motion)
    return move(command::MoveRelative{what.distance, what.dynamics});
  if (!std::isfinite(what.distance)) return Refusal{Cause::no_value, what.distance};
  return superimpose(what.distance, what.dynamics);
}

// The goals of moves that begin in the state `from`.

std::optional<Refusal> MotionAxis::goal_of(const command::MoveAbsolute& what,
                                           const MotionState& from, Goal& goal) const {
  if (!std::isfinite(what.position)) return Refusal{Cause::no_value, what.position, 0};
  MoveDynamics dynamics = what.dynamics;
  if (const auto no = fill(dynamics, config_)) return no;
  const auto target = target_of(what.position, what.direction, from, dynamics, config_);
  if (!target) return Refusal{Cause::no_such_move, what.position, 0};
  goal = {Goal::Kind::position, *target, dynamics};
  return forbidden(*target, from.position);
}

std::optional<Refusal> MotionAxis::goal_of(const command::MoveRelative& what,
                                           const MotionState& from, Goal& goal) const {
  if (const auto no = distance_goal(what.distance, from.position, what.dynamics, goal)) return no;
  return forbidden(goal.value, from.position);
}

/// Counts from the target of the present move, if it has one.
std::optional<Refusal> MotionAxis::goal_of(const command::MoveAdditive& what,
                                           const MotionState& from, Goal& goal) const {
  const bool aimed = base_ == Base::move && goal_.kind != Goal::Kind::velocity;
  const double start = aimed ? goal_.value + above_.finished() : from.position;
  if (const auto no = distance_goal(what.distance, start, what.dynamics, goal)) return no;
  return forbidden(goal.value, from.position);
}

std::optional<Refusal> MotionAxis::goal_of(const command::MoveVelocity& what,
                                           const MotionState& from, Goal& goal) const {
  if (!std::isfinite(what.velocity)) return Refusal{Cause::no_value, what.velocity, 0};
  const auto& [a, d, j] = what.dynamics;
  MoveDynamics dynamics{.acceleration = a, .deceleration = d, .jerk = j};
  if (const auto no = fill(dynamics, config_)) return no;
  return velocity_goal(what.velocity, from, dynamics, goal);
}

std::optional<Refusal> MotionAxis::goal_of(const BufferedMove& what, const MotionState& from,
                                           Goal& goal) const {
  return std::visit([&](const auto& move) { return goal_of(move, from, goal); }, what);
}

std::optional<Refusal> MotionAxis::distance_goal(double distance, double from,
                                                 MoveDynamics dynamics, Goal& goal) const {
  if (!std::isfinite(distance)) return Refusal{Cause::no_value, distance, 0};
  if (const auto no = fill(dynamics, config_)) return no;
  goal = {Goal::Kind::position, from + distance, dynamics};
  return std::nullopt;
}

/// The goal of a move at this velocity; 0: to rest.
std::optional<Refusal> MotionAxis::velocity_goal(double velocity, const MotionState& from,
                                                 MoveDynamics dynamics, Goal& goal) const {
  const double most = dynamics.velocity;
  if (std::abs(velocity) > most) return Refusal{Cause::velocity_limit, velocity, most};
  const bool blocked =
      (velocity > 0 && inputs_.positive_switch) || (velocity < 0 && inputs_.negative_switch);
  if (blocked) return Refusal{Cause::direction_blocked, velocity, 0};
  const auto limit = velocity > 0   ? config_.limits.position_max
                     : velocity < 0 ? config_.limits.position_min
                                    : std::nullopt;
  const double near = 1e-9 * most * seconds(1);
  if (limit && (*limit - from.position) * std::copysign(1.0, velocity) < near)
    return Refusal{Cause::position_limit, from.position, *limit};
  dynamics.velocity = std::abs(velocity);
  goal = {Goal::Kind::velocity, velocity, dynamics};
  return std::nullopt;
}

/// Reason why no move may have this target.
std::optional<Refusal> MotionAxis::forbidden(double target, double from) const {
  const auto& [low, high, v, a, j] = config_.limits;
  if (low && target < *low) return Refusal{Cause::position_limit, target, *low};
  if (high && target > *high) return Refusal{Cause::position_limit, target, *high};
  const bool blocked =
      (inputs_.positive_switch && target > from) || (inputs_.negative_switch && target < from);
  return blocked ? std::optional(Refusal{Cause::direction_blocked, target, from}) : std::nullopt;
}

/// The greatest magnitudes of the motion below a superimposed move.
Peaks MotionAxis::beneath() const {
  if (on_path()) {
    const double r = std::max(1.0, clock_.target());
    const double kinks = peaks_.velocity_step / seconds(1);
    return {peaks_.velocity * r, std::max(peaks_.acceleration, kinks) * r * r,
            peaks_.jerk * r * r * r};
  }
  if (base_ != Base::move) {
    const Peaks ramp = active_->peaks();
    return {std::abs(bare_.velocity), std::max(std::abs(bare_.acceleration), ramp.acceleration),
            ramp.jerk};
  }
  const MoveDynamics& d = goal_.dynamics;
  // The state at the start of the move may take it beyond its own dynamics.
  const Peaks planned = peaks(plan_);
  return {std::max(planned.velocity, d.velocity * std::max(1.0, factor_)),
          std::max({planned.acceleration, d.acceleration, d.deceleration}),
          config_.limits.jerk ? std::max(planned.jerk, d.jerk) : 0};
}

/// Begins a move on top of the present motion, or returns the reason to reject it.
MotionAxis::Rejection MotionAxis::superimpose(double distance, const MoveDynamics& dynamics) {
  if (on_path() && !clock_.steady(now_.tick)) return Refusal{.cause = Cause::rate_changing};
  if (boundary_ == Boundary::swap || passes()) return Refusal{.cause = Cause::in_motion};
  const auto end = expected_end();
  return above_.begin(now_.tick, distance, dynamics, beneath(),
                      end ? std::optional(end->position) : std::nullopt);
}

/// The slave keeps its velocity (PMC600 manual 6.1, 6.2); MC_Stop or another move follows.
MotionAxis::Rejection MotionAxis::decouple() {
  if (!active_) return Refusal{Cause::not_synchronized};
  leave(Goal::Kind::velocity);
  if (base_ != Base::move) return Refusal{Cause::no_such_move};
  return std::nullopt;
}

// ---- planning ----------------------------------------------------------------------------------

/// A move replaces any present motion, and continues from its last setpoint.
bool MotionAxis::go(const Goal& goal) {
  const bool was_moving = moving();
  if (!adopt(goal, factor_)) return false;
  held_ = false;
  if (!was_moving) begun_ = emitted_ = now_.tick;  // more commands may follow in this tick
  ending_ = Ending::none;
  now_.reason = was_moving ? Cause::replaced : Cause::none;
  state_ = goal.kind == Goal::Kind::velocity ? State::continuous_motion : State::discrete_motion;
  return true;
}

bool MotionAxis::adopt(const Goal& goal, double factor) {
  if (!plan_from(last(), moving() ? emitted_ : now_.tick, goal, factor)) return false;
  if (boundary_ == Boundary::swap) disarm();
  boundary_ = Boundary::none;
  drop_movement();
  above_.clear();
  bare_ = last();
  base_ = Base::move;
  return true;
}

bool MotionAxis::plan_from(const MotionState& from, std::int64_t tick, const Goal& goal,
                           double factor) {
  Goal aim = goal;
  aim.through = through(from, goal, factor);
  // A homing waits by its own acceleration, any other move by that of the axis.
  const bool waits = homing_ && !(factor > 0);
  const Goal rest{Goal::Kind::rest, 0, goal.dynamics};
  const auto profile = waits ? plan(from, rest, 1, rules()) : plan(from, aim, factor, rules());
  if (!profile) return false;
  plan_ = *profile;
  goal_ = aim;
  origin_ = tick;
  ahead_ = 0;
  return true;
}

/// Plans the move for another rate. A move that comes to rest absorbs the superimposed move.
bool MotionAxis::replan_move() {
  const double rate = wanted_rate();
  if (rate > 0 || !above_.shifts()) return plan_from(bare_, emitted_, goal_, rate);
  Goal both = goal_;
  both.value += above_.distance();
  if (!plan_from(last(), emitted_, both, rate)) return false;
  bare_ = last();
  above_.clear();
  return true;
}

/// Brakes from the last good setpoint, and from the tick of its output.
void MotionAxis::brake(double deceleration) {
  const double jerk = config_.limits.jerk ? config_.stop_jerk : Bounds::none;
  for (const double a : {deceleration, std::max(deceleration, config_.stop_acceleration)}) {
    if (!adopt({Goal::Kind::rest, 0, {*config_.limits.velocity, a, a, jerk}}, 1)) return cut_off();
    ending_ = Ending::fault;
    if (stays_inside(plan_, rules())) return;  // otherwise harder
  }
}

/// Comes to rest at the end of the range, with the gentlest stop that the last good setpoint has.
bool MotionAxis::stop_at_limit(Cause limit) {
  const auto& [low, high, v_most, a_most, j_most] = config_.limits;
  const auto end = limit == Cause::positive_soft_limit ? high : low;
  const MotionState from = last();
  const Stop stop = gentlest_stop(from, config_);
  const bool outside =
      end && (limit == Cause::positive_soft_limit ? from.position > *end : from.position < *end);
  if (!end || outside || stop == Stop::none) return false;
  const double a = stop == Stop::soft ? config_.limit_acceleration : config_.stop_acceleration;
  const double j = j_most ? config_.stop_jerk : Bounds::none;
  const double own = std::abs(from.velocity) + from.acceleration * from.acceleration / (2 * j);
  // From rest, the velocity gained in this tick: so an axis that has just begun also reaches the
  // end.
  const double velocity = std::min(std::max(own, a * dt()), *v_most);
  const MoveDynamics dynamics{velocity, a, a, j};
  const auto rest = plan(from, {Goal::Kind::rest, 0, dynamics}, 1, config_);
  const double near = 10 * velocity * dt();  // otherwise it does not move towards the limit
  if (!rest || std::abs(*end - rest->end().position) > near) return false;
  if (!adopt({Goal::Kind::position, *end, dynamics}, 1)) return false;
  ending_ = Ending::fault;
  return true;
}

/// The coupling ends: the velocity stays, or the axis comes to rest.
void MotionAxis::leave(Goal::Kind kind) {
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
