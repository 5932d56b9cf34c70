// SPDX-License-Identifier: Apache-2.0
#include "axis/src/state/axis_impl.hpp"

// Changes of a move in progress: repetitive moves, and a new velocity, at once or at a position.

namespace jounce {

MotionAxis::Impl::Rejection MotionAxis::Impl::act(const command::MoveRepetitive& what) {
  const double start = now_.position;
  Goal there;
  if (auto no = motion_.own().first_stroke(what, last(), motion_.conditions(present()), there))
    return no;
  if (auto no = take_over(there)) return no;
  motion_.own().repeat(what, start);
  return std::nullopt;
}

MotionAxis::Impl::Rejection MotionAxis::Impl::act(const command::ChangeVelocity& what) {
  return motion_.change(what, present());
}

}  // namespace jounce
