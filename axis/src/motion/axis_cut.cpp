// SPDX-License-Identifier: Apache-2.0
#include "jounce/axis/detail/live_cuts.hpp"

#include "axis/src/state/axis_impl.hpp"

// The commands of a plan of cuts.

namespace jounce {

MotionAxis::Impl::Rejection MotionAxis::Impl::act(const command::Cut& what) {
  LiveCuts* const cuts = motion_.cuts();
  if (cuts == nullptr) return Refusal{Cause::no_cut_plan};
  return cuts->cut(what, motion_.live().master_shift());
}

MotionAxis::Impl::Rejection MotionAxis::Impl::act(const command::Park& /*it*/) {
  LiveCuts* const cuts = motion_.cuts();
  if (cuts == nullptr) return Refusal{Cause::no_cut_plan};
  cuts->park();
  return std::nullopt;
}

}  // namespace jounce
