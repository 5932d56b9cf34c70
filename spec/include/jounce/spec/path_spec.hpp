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
#include "jounce/path/program_numbers.hpp"

namespace jounce {

/// A spec of kind "path": several axes along lines and arcs. Numbers are in the spec's units.
struct PathSpec {
  Program program{1};       ///< commands of the path
  GroupLimits limits = {};  ///< [limits] of the axes and [path.limits]
  /// The joints of the machine: [kinematics]. In Spec::axes, they follow the axes of the program.
  std::optional<JointSpace> joints = {};
  std::string source = {};  ///< name of the document to which the source lines of commands refer
  std::vector<GcodeEvent> events = {};  ///< G-code words that move no axis
  std::vector<int> rapids = {};         ///< lines of the G-code with a rapid (G0), ascending
  GcodeMachine machine = {};            ///< settings for a G-code program that is given separately
  /// Changes of the override during the motion: [[override]].
  std::vector<FactorRequest> override_steps = {};
  /// Options for lines that overlap in time, instead of rounded corners; omitted: rounded corners.
  std::optional<OverlapOptions> overlap = {};
  /// True: the timing law is refined (jounce/path/refine.hpp): [path] refine.
  bool refine = false;
  /// Greatest error of a fitted axis, in its unit. Omitted: 1e-9, or more for large coordinates.
  std::optional<double> tolerance = {};
};

/// Adds the commands of a G-code program to a path spec without commands (a machine). Throws
/// InputError, with the place, like parse_gcode(), and if the path already has commands.
void set_gcode(PathSpec& path, std::string_view text, const std::string& document);

/// Returns the program of a path with its limits and its M and H words, without names. S and T
/// words have no effect. Throws InputError, with the place, for a number that a ProgramWord cannot
/// have.
LimitedProgram limited_program(PathSpec path);

}  // namespace jounce
