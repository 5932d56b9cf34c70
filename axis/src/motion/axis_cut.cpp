// SPDX-License-Identifier: Apache-2.0
#include "jounce/axis/axis.hpp"
#include "jounce/axis/live_cuts.hpp"

// The commands of a plan of cuts.

namespace jounce {

MotionAxis::Rejection MotionAxis::act(const command::Cut& what) {
  LiveCuts* const cuts = base_ == Base::live ? live_->cuts() : nullptr;
  if (cuts == nullptr) return Refusal{Cause::no_cut_plan};
  return cuts->cut(what, live_.master_shift());
}

MotionAxis::Rejection MotionAxis::act(const command::Park& /*it*/) {
  LiveCuts* const cuts = base_ == Base::live ? live_->cuts() : nullptr;
  if (cuts == nullptr) return Refusal{Cause::no_cut_plan};
  cuts->park();
  return std::nullopt;
}

}  // namespace jounce
