// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <variant>

#include "jounce/gear/flying_shear.hpp"
#include "jounce/gear/follow_plan.hpp"
#include "jounce/gear/follow_start.hpp"
#include "jounce/gear/gear_course.hpp"
#include "jounce/gear/gear_in_pos.hpp"
#include "jounce/gear/indexer.hpp"
#include "jounce/gear/rotary_knife.hpp"
#include "jounce/gear/sync_cam.hpp"

/// Specs of slaves that work with their master: one struct a kind, each with what its
/// generator in `gear/` takes. Numbers are in the spec's units.
namespace jounce {

/// kind = "gear": slave = master * numerator / denominator, without drift.
struct GearSpec {
  std::int64_t numerator = 1;
  std::int64_t denominator = 1;
  double master_period = 1;  ///< m: of the table, which goes on from where it ends
};

/// kind = "gear", engage = "position": MC_GearInPos. With engage = "distance" it is a GearCourse.
struct GearInPosPart {
  GearInPosSpec gear;
  double master_start = 0, master_end = 0;  ///< m: as far as the cam goes
};

/// kind = "follow": tables as a controller takes them, or what they are to do.
struct FollowPart {
  std::variant<FollowSpec, FollowPlan> slave;
  FollowStart start = {};
};

/// Kinds "knife", "shear" and "indexer" are what their generators take.
using SyncSpec = std::variant<GearSpec, GearCourse, GearInPosPart, FollowPart, RotaryKnifeSpec,
                              FlyingShear, Indexer>;

/// m after which it repeats; nothing where it runs once.
std::optional<double> master_period(const SyncSpec& spec);

}  // namespace jounce
