#include <utility>

#include "jounce/axis/axis.hpp"

// What waits: a command for its tick; and the move that waits for the end of the motion under way (BufferMode), and how it takes over: from
// rest, or where the move before passes its target.

namespace jounce {

/// One command with a tick of its own waits for that. What it needs is looked at then.
void MotionAxis::postpone(const Command& command) {
  const auto at = static_cast<double>(command.at);
  if (command.at < now_.tick) return refuse(Cause::too_late, at, static_cast<double>(now_.tick));
  if (later_) return refuse(Cause::buffer_full, at, static_cast<double>(later_->at));
  if (command.movement) {
    refuse(Cause::no_value);
    return hand_back(command.movement);
  }
  later_ = command;
}

/// In its tick, or the next one that is stepped, it is obeyed before the command of that tick.
void MotionAxis::obey_due() {
  if (!later_ || later_->at > now_.tick) return;
  Command command = *later_;
  later_.reset();
  command.at = -1;
  obey(command);
  if (now_.refused) now_.dropped = now_.refused;  // nobody waits for its answer
  now_.refused.reset();
}

void MotionAxis::forget_later() {
  if (later_) now_.dropped = Refusal{Cause::replaced, static_cast<double>(later_->at), 0, 0};
  later_.reset();
}

/// It is looked at where the motion will end, if that is known, and again when it begins.
void MotionAxis::buffer(const Command& command) {
  if (next_) return refuse(Cause::buffer_full);
  if (base_ == Base::movement && !on_path()) return refuse(Cause::synchronized);
  Goal goal;
  if (now_.refused = goal_of(command, expected_end().value_or(last()), goal); now_.refused) return;
  next_ = command;
  if (base_ == Base::move && ending_ == Ending::none && wanted_rate() > 0) replan();
}

/// At which velocity a move to this goal passes it on to the next one. Where something was superimposed
/// on it that ends at rest: the next one's target is a place without that.
double MotionAxis::through(const MotionState& from, const Goal& goal, double factor) const {
  if (!next_ || lifting_ || shift_ != 0 || goal.kind != Goal::Kind::position) return 0;
  Goal further;
  if (goal_of(*next_, {goal.value, 0, 0}, further)) return 0;
  return passing_velocity(from, goal, further, next_->buffer, factor, config_);
}

/// The target was passed since the tick before: the plan from there goes on at the very instant. Or why
/// it cannot: as long as it moves that way, only for a limit switch.
Cause MotionAxis::pass_target() {
  const double beyond = plan_time() - plan_.duration();
  const MotionState there = plan_.end();
  Goal goal;
  if (goal_of(*next_, {goal_.value, 0, 0}, goal))
    return there.velocity > 0 ? Cause::positive_switch : Cause::negative_switch;
  next_.reset();
  if (!plan_from(there, now_.tick, goal, factor_)) return Cause::jump;
  ahead_ = beyond;
  ++now_.finished;
  state_ = goal.kind == Goal::Kind::velocity ? State::continuous_motion : State::discrete_motion;
  return Cause::none;
}

/// The move under way ends at its target then. Where it is too late for that it goes on as it was told.
void MotionAxis::take_back_next() {
  const auto next = std::exchange(next_, std::nullopt);
  if (!next) return;
  const bool blends = base_ == Base::move && goal_.through != 0;
  if (blends && !plan_from(bare_, emitted_, goal_, wanted_rate())) {
    next_ = next;
    return refuse(Cause::no_such_move, goal_.value);
  }
  now_.dropped = Refusal{Cause::replaced, next->position, 0, 0};
}

/// What waited begins in the tick in which the motion before has ended.
void MotionAxis::begin_next() {
  const Command command = *next_;
  next_.reset();
  Goal goal;
  if (const auto no = goal_of(command, last(), goal)) {
    now_.dropped = no;
    return;
  }
  go(goal);
}

/// Something else has taken its place.
void MotionAxis::forget_next() {
  if (next_) now_.dropped = Refusal{Cause::replaced, next_->position, 0, 0};
  next_.reset();
}

}  // namespace jounce
