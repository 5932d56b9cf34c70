// SPDX-License-Identifier: Apache-2.0
#include "axis/src/state/axis_impl.hpp"

// Changes of a move in progress: repetitive moves, and a new velocity, at once or at a position.

namespace jounce {

MotionAxis::Impl::Rejection MotionAxis::Impl::act(const command::MoveRepetitive& what) {
  const double start = now_.position;
  Goal there;
  if (auto no = own_.first_stroke(what, last(), conditions(), there)) return no;
  if (auto no = take_over(there)) return no;
  own_.repeat(what, start);
  return std::nullopt;
}

MotionAxis::Impl::Rejection MotionAxis::Impl::act(const command::ChangeVelocity& what) {
  if (ending_ != Ending::none) return Refusal{Cause::halting};
  if (base_ != Base::move) return Refusal{Cause::not_a_move};
  return own_.change(what, bare_, conditions());
}

}  // namespace jounce
