// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "jounce/io/gcode.hpp"
#include "jounce/path/axis_map.hpp"
#include "jounce/path/group_limits.hpp"
#include "jounce/path/overlap.hpp"
#include "jounce/path/override.hpp"
#include "jounce/path/program.hpp"

namespace jounce {

/// kind = "path": several axes along lines and arcs. Numbers are in the spec's units.
struct PathSpec {
  Program program{1};
  GroupLimits limits;
  /// [kinematics]: the joints behind the axes. Spec::axes has them behind the axes of the program.
  std::optional<JointSpace> joints = {};
  std::string source;              ///< document that the lines of the commands count in
  std::vector<GcodeEvent> events;  ///< events of a G-code program
  GcodeMachine machine;            ///< for a G-code program from elsewhere
  std::vector<FactorRequest> override_steps = {};  ///< [[override]]: the motion is played under it
  std::optional<OverlapOptions> overlap = {};  ///< lines that overlap in time, instead of corners
  /// Greatest error of an axis where it is fitted; unit of the axis. Left out: 1e-9, more for large coordinates.
  std::optional<double> tolerance = {};
};

/// A path spec without commands is a machine: this gives it a G-code program. Throws InputError, placed: parse_gcode();
/// a path that has commands already.
void set_gcode(PathSpec& path, std::string_view text, const std::string& document);

}  // namespace jounce
