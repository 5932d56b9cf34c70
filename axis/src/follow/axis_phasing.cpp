// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "axis/src/state/axis_impl.hpp"

// The phase shift of an axis that follows a live master.

namespace jounce {

MotionAxis::Impl::Rejection MotionAxis::Impl::shift_phase(double target,
                                                          const MoveDynamics& dynamics) {
  if (base_ != Base::live) return Refusal{Cause::no_master_input};
  if (live_->cuts() != nullptr) return Refusal{Cause::in_cut_plan};
  if (!std::isfinite(target)) return Refusal{Cause::no_value, target};
  const Peaks engaging = live_->peaks();
  const Peaks above = above_.peaks();
  const PhaseBase base{live_->slopes(),
                       inputs_.master,
                       {.velocity = engaging.velocity + above.velocity,
                        .acceleration = engaging.acceleration + above.acceleration,
                        .jerk = engaging.jerk + above.jerk}};
  return live_.phase().begin(now_.tick, target, dynamics, base, config_);
}

MotionAxis::Impl::Rejection MotionAxis::Impl::act(const command::PhasingAbsolute& what) {
  return shift_phase(what.shift, what.dynamics);
}

MotionAxis::Impl::Rejection MotionAxis::Impl::act(const command::PhasingRelative& what) {
  return shift_phase(live_.phase().at(now_.tick)[0] + what.shift, what.dynamics);
}

}  // namespace jounce
