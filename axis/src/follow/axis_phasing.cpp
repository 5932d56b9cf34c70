// SPDX-License-Identifier: Apache-2.0
#include "axis/src/state/axis_impl.hpp"

// The phase shift of an axis that follows a live master.

namespace jounce {

MotionAxis::Impl::Rejection MotionAxis::Impl::act(const command::PhasingAbsolute& what) {
  return motion_.shift_phase(what.shift, what.dynamics, present());
}

MotionAxis::Impl::Rejection MotionAxis::Impl::act(const command::PhasingRelative& what) {
  const double from = motion_.live().phase().at(now_.tick)[0];
  return motion_.shift_phase(from + what.shift, what.dynamics, present());
}

}  // namespace jounce
