// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "axis/src/group/group_role.hpp"
#include "axis/src/motion/motion_rules.hpp"
#include "axis/src/state/axis_impl.hpp"

// A group of the machine (AxisGroup in machine.hpp), and an axis of a group. The machine connects
// them by Inputs::peers: a group reads whether its axes can follow it, an axis whether its group is
// enabled or moves.

namespace jounce {

/// The reason why a group at rest cannot begin or continue its path, or none.
MotionAxis::Impl::Rejection MotionAxis::Impl::against_peers() const {
  if (!is_group() || (on_path() && !motion_.path().rests(now_.tick))) return std::nullopt;
  return against_axes(inputs_);
}

/// The setpoints of both paths are equal here, so the group goes on without a step.
MotionAxis::Impl::Rejection MotionAxis::Impl::extend(const command::Extend& what) {
  Movement* const movement = what.movement;
  if (!movement) return Refusal{Cause::no_value};
  auto no = against_extension(what, motion_, now_.tick);
  if (const Cause cause = movement->begin({what.position, 0, 0}, moment());
      cause != Cause::none && !no)
    no = Refusal{cause};
  if (no) {
    hand_back(movement);
    return no;
  }
  hand_back(motion_.path().path());
  motion_.path().take_over(*movement, now_.tick, what.shift);
  outputs_.continue_as(*movement, what.shift);
  return std::nullopt;
}

/// An axis at standstill follows its group from the tick in which the group moves.
void MotionAxis::Impl::follow_group() {
  if (inputs_.peers != Peers::led || state_ != State::standstill || moving()) return;
  state_ = State::synchronized_motion;
  now_.reason = Cause::none;
  motion_.begin_group(now_.tick);
}

Cause MotionAxis::Impl::advance_group(Setpoint& next) const {
  const bool led = inputs_.peers == Peers::led || inputs_.peers == Peers::landing;
  next = {0, 0, inputs_.master};
  return led && std::isfinite(inputs_.master[0]) ? Cause::none : Cause::master_lost;
}

std::span<const Jet> MotionAxis::Impl::places() const {
  return !on_path() && slot_.armed() ? slot_.armed()->parts() : parts();
}

}  // namespace jounce
