// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "jounce/base/units.hpp"
#include "jounce/path/program.hpp"
#include "jounce/spec/path_spec.hpp"

#include "spec/src/toml/parts.hpp"

namespace jounce::spec_detail {

/// Names and units of the axes of a path. The first `path_axes` measure its length, the others follow.
struct PathAxes {
  Units units;  ///< units of the path axes
  std::vector<std::string> names = {};
  std::vector<std::string> position_units = {};
  std::size_t path_axes = 0;

  [[nodiscard]] std::size_t size() const { return names.size(); }
  [[nodiscard]] std::string unit(int order) const {
    return rate_unit(units.position, units.x, order);
  }
};

/// key = [a, b, ...]: one number for each axis, counted from `origin`. Required.
Point read_position(TomlReader& reader, const char* key, const PathAxes& axes, const Point& origin);

/// A number greater than 0.
std::optional<double> read_magnitude(TomlReader& reader, const char* key, const std::string& unit);

/// velocity, corner, junction: of [path], and of a command from which on they hold.
void read_path_settings(TomlReader& owner, const PathAxes& axes, PathSettings& settings);

/// [[command]].
void read_path_command(TomlReader& command, const PathAxes& axes, PathSettings& settings,
                       Program& program);

/// [[command]], points, or [gcode] with a file. Without any of them the path is a machine for a program.
void read_program(TomlReader& top, const PathAxes& axes, PathSettings settings, PathSpec& path);

}  // namespace jounce::spec_detail
