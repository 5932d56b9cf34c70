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

/// Specs of kind "pt": tables over time that are played unchanged. Numbers are in the spec's units.

namespace jounce {

/// A PT table: for a Googol iDEABOX, or independent of a controller.
struct PtSpec {
  std::vector<PtPoint> points = {};
  std::size_t loops = 1;      ///< number of passes; 0: endless
  double start_velocity = 0;  ///< initial velocity of a first point of type `continue`
  Extrapolation outside = Extrapolation::hold;  ///< policy outside the table
  bool googol = false;                          ///< true: the limits of a Googol controller apply
};

/// A table of the PMC600: MC_PositionProfile, MC_VelocityProfile or MC_AccelerationProfile.
struct ProfileTableSpec {
  enum class Quantity { position, velocity, acceleration } quantity = Quantity::position;
  pmc600::ProfileTable table = {};
  /// Motion between the points of a position table.
  pmc600::PositionRule rule = pmc600::PositionRule::cubic;
  Extrapolation outside = Extrapolation::hold;  ///< policy outside the table
};

using TimeTableSpec = std::variant<PtSpec, ProfileTableSpec>;

/// Returns the motion of the table. Throws InputError with the keys of the document.
Trajectory motion_of(const TimeTableSpec& spec);

/// Returns a name for each segment of the motion: "2 even", "pass 3: 2 even". Empty for a table of
/// the PMC600.
std::vector<std::string> labels_of(const TimeTableSpec& spec);

/// Returns the findings of check_pt() or velocity_steps(), and of overshoot(), for the table
/// (jounce/pvt/pt.hpp, warnings.hpp). For a table with several passes, they cover all passes
/// together. `unit`: unit of the velocity, for the advice.
Report warnings_of(const TimeTableSpec& spec, const std::string& unit = "");

}  // namespace jounce
