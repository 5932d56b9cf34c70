// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <variant>
#include <vector>

#include "jounce/profiles/curve/curve.hpp"
#include "jounce/profiles/limits/limits.hpp"
#include "jounce/pvt/profile_table.hpp"
#include "jounce/pvt/pt.hpp"

/// A spec of kind "pt": a time table that is played unchanged. Numbers are in the spec's
/// units.
namespace jounce {

/// A PT table: of a Googol iDEABOX, or of no controller in particular.
struct PtSpec {
  std::vector<PtPoint> points;
  std::size_t loops = 1;      ///< 0: without end
  double start_velocity = 0;  ///< initial velocity of a `continue` first point
  Extrapolation outside = Extrapolation::hold;
  bool googol = false;  ///< its limits hold
};

/// PMC600: MC_PositionProfile, MC_VelocityProfile, MC_AccelerationProfile.
struct ProfileTableSpec {
  enum class Quantity { position, velocity, acceleration } quantity = Quantity::position;
  pmc600::ProfileTable table;
  pmc600::PositionRule rule = pmc600::PositionRule::cubic;
  Extrapolation outside = Extrapolation::hold;
};

using TimeTableSpec = std::variant<PtSpec, ProfileTableSpec>;

/// The motion. Throws InputError with the document's keys.
Trajectory motion_of(const TimeTableSpec& spec);

/// A name for each of its segments: "2 even", "pass 3: 2 even"; none for PMC600's.
std::vector<std::string> labels_of(const TimeTableSpec& spec);

/// Its findings: check_pt or velocity_steps, and overshoot. A table in several passes is
/// looked at once.
Report warnings_of(const TimeTableSpec& spec);

}  // namespace jounce
