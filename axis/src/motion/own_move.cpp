// SPDX-License-Identifier: Apache-2.0
#include "axis/src/motion/own_move.hpp"

#include <cmath>
#include <utility>

namespace jounce {

bool OwnMove::plan(const TimedState& from, const Goal& goal, double factor,
                   const MoveConditions& now, double ahead) noexcept {
  Goal aim = goal;
  aim.through = through(from.state, goal, factor, now);
  // A homing waits by its own acceleration, any other move by that of the axis.
  if (now.searches && !(factor > 0)) return player_.pause(from, aim, now.rules);
  return player_.begin(from, aim, factor, now.rules, ahead);
}

/// The velocity at which a move to this goal passes it on to the next goal. With a superimposed
/// move, the move ends at rest: the next target does not include the superimposed distance.
double OwnMove::through(const MotionState& from, const Goal& goal, double factor,
                        const MoveConditions& now) const noexcept {
  if (next_.empty() || repeats() || now.shifted || goal.kind != Goal::Kind::position) return 0;
  Goal further;
  if (goal_of(next_.front(), {goal.value, 0, 0}, rules(now), further)) return 0;
  return passing_velocity(from, goal, further, buffer_of(next_.front()), factor, config_);
}

OwnMove::Step OwnMove::advance(const MoveConditions& now) noexcept {
  Step step;
  step.dropped = change_if_passed(now);
  step.fault = begin_strokes(now);
  if (step.fault != Cause::none) return step;
  while (passes() && player_.is_over(now.tick)) {
    step.fault = pass_target(now);
    if (step.fault != Cause::none) return step;
    ++step.passed;
  }
  return step;
}

/// The target was passed since the previous tick: the plan continues from there at that very
/// instant. Returns the cause if it cannot: in the direction of motion, only a limit switch.
Cause OwnMove::pass_target(const MoveConditions& now) noexcept {
  const MotionState there = player_.plan().end();
  Goal next;
  if (goal_of(next_.front(), {goal().value, 0, 0}, rules(now), next))
    return there.velocity > 0 ? Cause::positive_switch : Cause::negative_switch;
  next_.pop();
  const bool goes_on = plan({there, now.tick}, next, now.factor, now, player_.beyond(now.tick));
  return goes_on ? Cause::none : Cause::jump;
}

// ---- strokes, and another velocity ---------------------------------------------------------------

std::optional<Refusal> OwnMove::first_stroke(const command::MoveRepetitive& what,
                                             const MotionState& from, const MoveConditions& now,
                                             Goal& there) const noexcept {
  Goal back;
  const command::MoveAbsolute first{what.position, what.dynamics};
  if (auto no = goal_of(first, from, rules(now), there)) return no;
  const MotionState other{there.value, 0, 0};
  const double start = from.position;
  if (auto no = goal_of(command::MoveRelative{start - there.value, what.dynamics}, other, {config_},
                        back))
    return no;
  if (!std::isfinite(what.wait)) return Refusal{Cause::no_value, what.wait};
  // Several strokes in a tick are not a motion.
  const auto stroke = jounce::plan(other, back, 1, config_);
  const double least = seconds(config_.period);
  if (!stroke || there.value == start || !(stroke->duration() + what.wait >= least))
    return Refusal{Cause::no_such_move, there.value};
  return std::nullopt;
}

/// Begins the strokes that are due, each from the instant at which the rest before it has ended.
Cause OwnMove::begin_strokes(const MoveConditions& now) noexcept {
  if (!repetition_ || now.stopping || !(now.rate > 0)) return Cause::none;
  while (repetition_->goes_on() && player_.is_over(now.tick)) {
    const double ahead = player_.beyond(now.tick) - repetition_->wait();
    if (ahead < 0) break;
    Goal next = goal();
    const MotionState from{next.value, 0, 0};
    next.value = repetition_->next();
    repetition_->turn();
    if (!plan({from, now.tick}, next, now.factor, now, ahead)) return Cause::jump;
  }
  return Cause::none;
}

std::optional<Refusal> OwnMove::change(const command::ChangeVelocity& what, const TimedState& from,
                                       const MoveConditions& now) noexcept {
  const bool rests =
      goal().kind == Goal::Kind::rest || (goal().kind == Goal::Kind::velocity && goal().value == 0);
  if (rests) return Refusal{Cause::not_a_move};
  if (!std::isfinite(what.velocity)) return Refusal{Cause::no_value, what.velocity};
  if (!(what.velocity > 0)) return Refusal{Cause::not_positive, what.velocity};
  if (what.velocity > *config_.limits.velocity)
    return Refusal{Cause::velocity_limit, what.velocity, *config_.limits.velocity};
  if (std::isnan(what.position)) return change_velocity(what.velocity, from, 0, now);
  if (!std::isfinite(what.position)) return Refusal{Cause::no_value, what.position};
  change_ = what;
  return std::nullopt;
}

/// Plans the move again, with another velocity, from a state that it had `ahead` s before the tick
/// of this state.
std::optional<Refusal> OwnMove::change_velocity(double velocity, const TimedState& from,
                                                double ahead, const MoveConditions& now) noexcept {
  Goal next = goal();
  // The superimposed move was planned within the limits that the present velocity left.
  if (now.added && velocity > next.dynamics.velocity)
    return Refusal{Cause::in_motion, velocity, next.dynamics.velocity};
  next.dynamics.velocity = velocity;
  if (next.kind == Goal::Kind::velocity) next.value = std::copysign(velocity, next.value);
  if (!plan(from, next, now.rate, now, ahead)) return Refusal{Cause::no_such_move, velocity};
  return std::nullopt;
}

/// Applies the change that waits for a position, from the instant at which the move passes it. A
/// change that is not possible is dropped: the move continues unchanged.
std::optional<Refusal> OwnMove::change_if_passed(const MoveConditions& now) noexcept {
  if (!change_ || now.stopping || !(now.rate > 0)) return std::nullopt;
  const double place = change_->position - now.shift;
  const auto ago = player_.passed(place, change_->direction, now.last_tick, now.tick);
  if (!ago) return std::nullopt;
  const double velocity = change_->velocity;
  change_.reset();
  return change_velocity(velocity, {player_.state(now.tick, *ago), now.tick}, *ago, now);
}

void OwnMove::forget_changes() noexcept {
  repetition_.reset();
  change_.reset();
}

// ---- moves that wait -----------------------------------------------------------------------------

std::optional<Refusal> OwnMove::buffer(const BufferedMove& move, std::optional<MotionState> end,
                                       const MotionState& last, const TimedState* planned,
                                       const MoveConditions& now) noexcept {
  constexpr auto most = static_cast<double>(WaitingMoves::most);
  if (next_.full()) return Refusal{Cause::buffer_full, most, most};
  const MotionState from = end_of(next_, end, rules(now)).value_or(last);
  Goal goal_after;
  if (auto no = goal_of(move, from, rules(now), goal_after)) return no;
  next_.push(move);
  const bool follows = next_.size() == 1;  // follows the present move, which may pass its target
  if (!follows || planned == nullptr || !(now.rate > 0)) return std::nullopt;
  if (plan(*planned, goal(), now.rate, now)) return std::nullopt;
  next_.clear();
  return Refusal{Cause::no_such_move};
}

bool OwnMove::withdraw(const TimedState* planned, const MoveConditions& now) noexcept {
  const bool blends = planned != nullptr && passes();
  const WaitingMoves waited = take_all();
  if (!blends || plan(*planned, goal(), now.rate, now)) return true;
  next_ = waited;
  return false;
}

BufferedMove OwnMove::take_next() noexcept {
  const BufferedMove move = next_.front();
  next_.pop();
  return move;
}

WaitingMoves OwnMove::take_all() noexcept {
  return std::exchange(next_, {});
}

std::optional<Refusal> replaced(const WaitingMoves& moves) noexcept {
  if (moves.empty()) return std::nullopt;
  return Refusal{Cause::replaced, value_of(moves.front()), 0};
}

}  // namespace jounce
