// SPDX-License-Identifier: Apache-2.0
#include <utility>

#include "axis/src/state/axis_impl.hpp"

// Waiting commands: one command for its tick, and the moves that wait for the end of the present
// motion (BufferMode). The first of these moves takes over when the motion is at rest, or at the
// point at which the previous move passes its target. A waiting move is planned to end at rest
// until it is in progress. If the moves after it are withdrawn, it can therefore still stop at its
// target.

namespace jounce {

MotionAxis::Impl::Rejection MotionAxis::Impl::postpone(const Command& command) {
  auto no = later_.postpone(command, now_.tick);
  if (no && no->cause == Cause::no_value) hand_back(movement_of(command.what));
  return no;
}

/// Executes the command that waits in its tick, before the command of that tick.
void MotionAxis::Impl::obey_due() {
  const auto command = later_.take_due(now_.tick);
  if (!command) return;
  obey(*command);
  if (now_.refused) now_.dropped = now_.refused;  // no sender waits for its answer
  now_.refused.reset();
}

void MotionAxis::Impl::forget_later() {
  if (const auto why = later_.forget()) now_.dropped = why;
}

/// Checks the move against the end of the previous one, if that is available, and again when it
/// begins.
MotionAxis::Impl::Rejection MotionAxis::Impl::buffer(const BufferedMove& move) {
  constexpr auto most = static_cast<double>(WaitingMoves::most);
  if (next_.full()) return Refusal{Cause::buffer_full, most, most};
  if (base_ == Base::live) return Refusal{Cause::synchronized};
  const MotionState from = end_of(next_, expected_end(), move_rules()).value_or(last());
  Goal goal;
  if (auto no = goal_of(move, from, move_rules(), goal)) return no;
  next_.push(move);
  const bool follows = next_.size() == 1;  // follows the present move, which may pass its target
  if (!follows || base_ != Base::move || !(requested_rate() > 0)) return std::nullopt;
  const auto no = replan();
  if (no) next_.clear();
  return no;
}

/// The velocity at which a move to this goal passes it on to the next goal. With a superimposed
/// move, the move ends at rest: the next target does not include the superimposed distance.
double MotionAxis::Impl::through(const MotionState& from, const Goal& goal, double factor) const {
  if (next_.empty() || repeats() || above_.shifts() || goal.kind != Goal::Kind::position) return 0;
  Goal further;
  if (goal_of(next_.front(), {goal.value, 0, 0}, move_rules(), further)) return 0;
  return passing_velocity(from, goal, further, buffer_of(next_.front()), factor, config_);
}

bool MotionAxis::Impl::passes() const {
  return !next_.empty() && base_ == Base::move && move_.passes();
}

/// The target was passed since the previous tick: the plan continues from there at that very
/// instant. Returns the cause if it cannot: in the direction of motion, only a limit switch.
Cause MotionAxis::Impl::pass_target() {
  const MotionState there = move_.plan().end();
  Goal goal;
  if (goal_of(next_.front(), {move_.goal().value, 0, 0}, move_rules(), goal))
    return there.velocity > 0 ? Cause::positive_switch : Cause::negative_switch;
  next_.pop();
  if (!plan_from({there, now_.tick}, goal, factor_, move_.beyond(now_.tick))) return Cause::jump;
  ++now_.finished;
  state_ = goal.kind == Goal::Kind::velocity ? State::continuous_motion : State::discrete_motion;
  return Cause::none;
}

/// The present move then ends at its target. If it is too late for that, the move continues
/// unchanged.
MotionAxis::Impl::Rejection MotionAxis::Impl::take_back_next() {
  const WaitingMoves waited = std::exchange(next_, {});
  const bool blends = base_ == Base::move && move_.passes();
  if (!waited.empty() && blends && !plan_from(bare_, move_.goal(), requested_rate())) {
    next_ = waited;
    return Refusal{Cause::no_such_move, move_.goal().value};
  }
  forget(waited);
  return std::nullopt;
}

/// The first waiting move begins in the tick in which the previous motion has ended. If it cannot,
/// the moves after it are dropped too: they would begin elsewhere.
void MotionAxis::Impl::begin_next() {
  const BufferedMove move = next_.front();
  next_.pop();
  Goal goal;
  auto no = goal_of(move, last(), move_rules(), goal);
  if (!no && !go(goal)) no = Refusal{Cause::no_such_move, goal.value, 0};
  if (!no) return;
  now_.dropped = no;
  next_.clear();
}

/// Another motion has replaced them; reports the first of them.
void MotionAxis::Impl::forget(const WaitingMoves& moves) {
  if (!moves.empty()) now_.dropped = Refusal{Cause::replaced, value_of(moves.front()), 0};
}

void MotionAxis::Impl::forget_next() {
  forget(std::exchange(next_, {}));
}

}  // namespace jounce
