// SPDX-License-Identifier: Apache-2.0
#include "jounce/gear/gear.hpp"
#include "jounce/spec/detail/in_document.hpp"
#include "jounce/spec/detail/of_follow.hpp"

#include "design/src/sync/sync_cam.hpp"
#include "design/src/sync/sync_gear.hpp"

namespace jounce {
namespace {

using spec_detail::in_document;
using spec_detail::of_follow;

SyncCam made(const GearSpec& spec) {
  const Gear gear = Gear::ratio(spec.numerator, spec.denominator);
  const double travel = spec.master_period * static_cast<double>(gear.numerator()) /
                        static_cast<double>(gear.denominator());
  return {Cam({line(spec.master_period, 0, travel)}, 0, Extrapolation::advance),
          {"gear"},
          {{0, spec.master_period, "gear"}}};
}

SyncCam made(const GearCourse& spec) {
  return design_detail::made_gear(spec);
}

SyncCam made(const GearInPosPart& spec) {
  return design_detail::made_gear(spec);
}

SyncCam made(const FollowPart& spec) {
  return of_follow(spec, [](const auto& slave) { return follow(slave); });
}

SyncCam made(const RotaryKnifeSpec& spec) {
  return in_document("knife.", [&] { return rotary_knife(spec); });
}

SyncCam made(const FlyingShear& spec) {
  return in_document("shear.", [&] { return flying_shear(spec); });
}

SyncCam made(const Indexer& spec) {
  return in_document("indexer.", [&] { return indexer(spec); });
}

}  // namespace

SyncCam sync_cam_of(const SyncSpec& spec) {
  return std::visit([](const auto& each) { return made(each); }, spec);
}

}  // namespace jounce
