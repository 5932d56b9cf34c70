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

MotionAxis::Impl::Rejection MotionAxis::Impl::take_back_next() {
  const WaitingMoves waited = motion_.own().waiting();
  if (!motion_.withdraw(present())) return Refusal{Cause::no_such_move, motion_.own().goal().value};
  note(replaced(waited));
  return std::nullopt;
}

/// The first waiting move begins in the tick in which the previous motion has ended. If it cannot,
/// the moves after it are dropped too: they would begin elsewhere.
void MotionAxis::Impl::begin_next() {
  const BufferedMove move = motion_.own().take_next();
  Goal goal;
  auto no = goal_of(move, last(), move_rules(), goal);
  if (!no && !go(goal)) no = Refusal{Cause::no_such_move, goal.value, 0};
  if (!no) return;
  now_.dropped = no;
  motion_.own().take_all();
}

/// Reports a waiting command or move that was dropped, if there is one.
void MotionAxis::Impl::note(const std::optional<Refusal>& why) {
  if (why) now_.dropped = why;
}

}  // namespace jounce
