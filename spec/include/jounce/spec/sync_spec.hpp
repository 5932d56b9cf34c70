// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <variant>

#include "jounce/gear/cut_list.hpp"
#include "jounce/gear/flying_shear.hpp"
#include "jounce/gear/follow_plan.hpp"
#include "jounce/gear/follow_start.hpp"
#include "jounce/gear/gear_course.hpp"
#include "jounce/gear/gear_in_pos.hpp"
#include "jounce/gear/indexer.hpp"
#include "jounce/gear/rotary_knife.hpp"
#include "jounce/gear/sync_cam.hpp"

/// Specs of synchronous slaves: one struct for each kind, with the parameters of its generator in
/// the module gear. Numbers are in the spec's units.

namespace jounce {

/// kind = "gear": slave = master * numerator / denominator, without drift. m is the master's unit.
struct GearSpec {
  std::int64_t numerator = 1;    ///< any sign
  std::int64_t denominator = 1;  ///< > 0
  double master_period = 1;      ///< m, length of the cam, which continues from its end
};

/// kind = "gear" with engage = "position": MC_GearInPos. (With engage = "distance" the spec is a
/// GearCourse.)
struct GearInPosPart {
  GearInPosSpec gear = {};
  double master_start = 0, master_end = 0;  ///< m, interval of the cam
};

/// kind = "follow": the tables of a controller, or a plan from which the tables are made.
struct FollowPart {
  std::variant<FollowSpec, FollowPlan> slave = {};
  FollowStart start = {};  ///< start event
  int direction = 0;       ///< direction of the master that moves the slave: 1, -1; 0: both
};

/// A spec of a synchronous slave. For the kinds "knife", "shear" and "indexer" it is the parameter
/// struct of the generator; for a knife or a shear with a list of pieces, a CutListSpec.
using SyncSpec = std::variant<GearSpec, GearCourse, GearInPosPart, FollowPart, RotaryKnifeSpec,
                              FlyingShear, Indexer, CutListSpec>;

/// Returns the cutter of a spec of kind "knife" or "shear", with its list: without one, a list of
/// one piece. nullopt for other kinds.
std::optional<CutListSpec> cut_list_of(const SyncSpec& spec);

/// Makes the cam of a synchronous slave. Throws InputError with the keys of the document.
SyncCam sync_cam_of(const SyncSpec& spec);

/// Returns the travel of the master (m) after which the motion of the slave repeats; nullopt if the
/// motion does not repeat.
std::optional<double> master_period(const SyncSpec& spec);

}  // namespace jounce
