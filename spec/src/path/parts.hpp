// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "jounce/base/units.hpp"
#include "jounce/path/frame.hpp"
#include "jounce/path/program.hpp"
#include "jounce/spec/path_spec.hpp"

#include "spec/src/toml/parts.hpp"

namespace jounce::spec_detail {

/// Names and units of the axes of a path. The first `path_axes` axes determine its length, the
/// others follow.
struct PathAxes {
  Units units;  ///< units of the path axes
  std::vector<std::string> names = {};
  std::vector<std::string> position_units = {};
  std::vector<double> modulo = {};  ///< one for each axis; > 0: period of a rotary axis
  std::size_t path_axes = 0;

  [[nodiscard]] std::size_t size() const { return names.size(); }
  [[nodiscard]] std::string unit(int order) const {
    return rate_unit(units.position, units.x, order);
  }
};

enum class Followers : std::uint8_t { required, optional };
/// Reads key = [a, b, ...]: one number for each axis, counted from `origin`. Required. Optional
/// followers that are left out are at `origin`.
Point read_position(TomlReader& reader, const char* key, const PathAxes& axes, const Point& origin,
                    Followers followers = Followers::required);

/// Reads `to`. For rotary axes, the absolute positions are moved by whole periods to the positions
/// nearest to the start.
Point read_end(TomlReader& reader, const PathAxes& axes, const Point& from, const Point* origin);

/// Reads velocity, corner and junction: of [path], or of a command; they apply from this command
/// on.
void read_path_settings(TomlReader& owner, const PathAxes& axes, PathSettings& settings);

/// Reads one [[command]].
void read_path_command(TomlReader& command, const PathAxes& axes, PathSettings& settings,
                       Program& program);

/// Reads offset, and rotation or zyz: of [frame], or of G54 to G59.
Frame read_frame(TomlReader frame, const PathAxes& axes);

/// Reads [kinematics] and [[joint]]. The joints are appended to spec.axes, after the axes of the
/// path. `taken`: names of the axes.
std::optional<JointSpace> read_kinematics(TomlReader& top, const PathAxes& axes, Spec& spec,
                                          std::set<std::string>& taken);

/// Reads [[command]], points, or [gcode] with a file. Without any of them, the path is a machine
/// for programs.
void read_program(TomlReader& top, const PathAxes& axes, const PathSettings& settings,
                  PathSpec& path);

}  // namespace jounce::spec_detail
