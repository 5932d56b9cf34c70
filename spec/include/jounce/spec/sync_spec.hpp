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

/// Specs of synchronous slaves: one struct for each kind, with the parameters of its generator in
/// `gear/`. Numbers are in the spec's units.
namespace jounce {

/// kind = "gear": slave = master * numerator / denominator, without drift.
struct GearSpec {
  std::int64_t numerator = 1;
  std::int64_t denominator = 1;
  double master_period = 1;  ///< m: period of the table, which continues from its end
};

/// kind = "gear", engage = "position": MC_GearInPos. With engage = "distance" it is a GearCourse.
struct GearInPosPart {
  GearInPosSpec gear;
  double master_start = 0, master_end = 0;  ///< m: extent of the cam
};

/// kind = "follow": the tables of a controller, or the motion from which the tables are planned.
struct FollowPart {
  std::variant<FollowSpec, FollowPlan> slave;
  FollowStart start = {};
};

/// For the kinds "knife", "shear" and "indexer", the spec is the parameter struct of the generator.
using SyncSpec = std::variant<GearSpec, GearCourse, GearInPosPart, FollowPart, RotaryKnifeSpec,
                              FlyingShear, Indexer>;

/// Master distance (unit m) after which the slave's motion repeats; nullopt if it runs once.
std::optional<double> master_period(const SyncSpec& spec);

}  // namespace jounce
